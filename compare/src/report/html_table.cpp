#include "html_table.hpp"

#include "format.hpp"
#include "templates.hpp"

namespace settle::compare::report {

namespace {

data data_of(const Column& column) {
  data entry;
  entry.set("title", column.title);
  entry.set("unit", text_or_nothing(column.unit));
  entry.set("numeric", column.numeric);
  return entry;
}

data data_of(const Cell& cell, const Column& column, bool heading, bool stacks) {
  data entry;
  entry.set("heading", heading);
  entry.set("numeric", column.numeric);
  entry.set("label", stacks && column.numeric ? data(column.title) : data(false));
  entry.set("text", printable(cell.text));
  entry.set("badge", text_or_nothing(cell.badge));
  entry.set("link", text_or_nothing(cell.link));
  entry.set("small_print", text_or_nothing(cell.small_print));
  return entry;
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
  for (const std::vector<Cell>& row : table.rows) {
    data cells(data::type::list);
    for (std::size_t i = 0; i < row.size(); ++i)
      cells.push_back(data_of(row[i], table.columns[i], i == 0, table.stacks));
    rows.push_back(data("cells", cells));
  }
  data entry;
  entry.set("caption", table.caption);
  entry.set("stacks", table.stacks);
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
