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

std::string escaped(const std::string& text) {
  return kainjow::mustache::html_escape(printable(text));
}

std::string content_of(const Cell& cell) {
  std::string html = escaped(cell.text);
  if (!cell.badge.empty()) html = fmt::format("<b class=\"{}\">{}</b>", escaped(cell.badge), html);
  if (!cell.link.empty()) html = fmt::format("<a href=\"{}\">{}</a>", escaped(cell.link), html);
  if (!cell.small_print.empty()) html += fmt::format("<small>{}</small>", escaped(cell.small_print));
  return html;
}

/// The opening tag of a cell that is no heading; without its label if the style sheet says it.
std::string opening_of(const Column& column, const Table& table) {
  if (!table.stacks || !column.numeric || !table.labels_cells) return "<td>";
  return fmt::format("<td data-label=\"{}\">", kainjow::mustache::html_escape(column.title));
}

/// All rows as HTML. Written here, not by the template: its values are copied at every level, and a page has 10⁴ cells.
std::string rows_of(const Table& table) {
  std::string html;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    html += table.marks.empty() ? "<tr>" : fmt::format("<tr {}>", table.marks[r]);
    for (std::size_t i = 0; i < table.rows[r].size(); ++i)
      html += (i == 0 ? "<th>" : opening_of(table.columns[i], table)) + content_of(table.rows[r][i]);
    html += "\n";
  }
  return html;
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

std::string html_of(const Table& table) {
  data columns(data::type::list);
  for (const Column& column : table.columns)
    columns.push_back(data_of(column));
  data entry;
  entry.set("caption", table.caption);
  entry.set("id", text_or_nothing(table.id));
  entry.set("classes", text_or_nothing(classes_of(table)));
  entry.set("columns", columns);
  entry.set("rows", rows_of(table));
  return render(templates::table, entry);
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
