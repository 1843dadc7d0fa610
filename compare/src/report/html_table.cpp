#include "html_table.hpp"

#include <fmt/format.h>

#include "format.hpp"
#include "templates.hpp"

namespace settle::compare::report {

namespace {

data data_of(const Column& column) {
  data entry;
  entry.set("title", column.title);
  entry.set("unit", text_or_nothing(column.unit));
  return entry;
}

data data_of(const Cell& cell, const Column& column, bool heading, const Table& table) {
  data entry;
  entry.set("heading", heading);
  const bool labelled = table.stacks && column.numeric && table.labels_cells;
  entry.set("label", labelled ? data(column.title) : data(false));
  entry.set("text", printable(cell.text));
  entry.set("badge", text_or_nothing(cell.badge));
  entry.set("link", text_or_nothing(cell.link));
  entry.set("small_print", text_or_nothing(cell.small_print));
  return entry;
}

/// "n2 n5": which columns are numeric. Said once: a class on every cell would be a third of a table's length.
std::string classes_of(const Table& table) {
  std::string classes = table.kind;
  const auto add = [&](const std::string& name) { classes += (classes.empty() ? "" : " ") + name; };
  if (table.stacks) add("stacks");
  if (table.sorts) add("sorts");
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].numeric) add(fmt::format("n{}", i + 1));
  }
  return classes;
}

} // namespace

data text_or_nothing(const std::string& text) {
  return text.empty() ? data(false) : data(printable(text));
}

data data_of(const Table& table) {
  data columns(data::type::list);
  for (const Column& column : table.columns)
    columns.push_back(data_of(column));
  data rows(data::type::list);
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    data cells(data::type::list);
    for (std::size_t i = 0; i < table.rows[r].size(); ++i)
      cells.push_back(data_of(table.rows[r][i], table.columns[i], i == 0, table));
    data row("cells", cells);
    row.set("mark", table.marks.empty() ? data(false) : data(table.marks[r]));
    rows.push_back(row);
  }
  data entry;
  entry.set("caption", table.caption);
  entry.set("id", text_or_nothing(table.id));
  entry.set("classes", text_or_nothing(classes_of(table)));
  entry.set("columns", columns);
  entry.set("rows", rows);
  return entry;
}

std::string html_of(const Table& table) {
  return render(templates::table, data_of(table));
}

std::string status_text(Status status) {
  const std::string word(name_of(status));
  switch (status) {
  case Status::passed:
    return "✓ " + word;
  case Status::failed:
    return "✗ " + word;
  case Status::missing:
    return "? " + word;
  case Status::error:
    return "! " + word;
  }
  return word;
}

Cell status_cell(Status status) {
  return {.text = status_text(status), .badge = std::string(name_of(status))};
}

} // namespace settle::compare::report
