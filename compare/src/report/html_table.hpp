/// \file
/// Tables of the page, and the small pieces from which the data of its templates is made.
#pragma once

#include <string>
#include <vector>

#include <kainjow/mustache.hpp>

#include "settle/compare/verdict.hpp"

namespace settle::compare::report {

using kainjow::mustache::data;

/// A template with its values filled in. What stands in text is escaped, unless the template says otherwise.
std::string render(const char* text, const data& values);

struct Column {
  std::string title;
  std::string unit;     ///< shown smaller, beside the title
  bool numeric = false; ///< figures in line at the right
};

struct Cell {
  std::string text;
  std::string badge = "";       ///< class of a badge around the text; none if empty
  std::string link = "";        ///< an address in the page; none if empty
  std::string small_print = ""; ///< a second, quieter line
};

struct Table {
  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows; ///< the first cell of a row is its heading
  bool stacks = false;                 ///< on a narrow screen a row becomes a block of lines instead of scrolling
  std::string id = "";                 ///< of the table; none if empty
  std::string kind = "";               ///< class of its own for the style sheet
  bool sorts = false;                  ///< the script may sort its rows by a column
  bool labels_cells = true;            ///< stacked cells say their column; else the style sheet says it for this kind
  std::vector<std::string> marks = {}; ///< attributes of each row, for the script; none if empty
};

/// A table as HTML.
std::string html_of(const Table& table);

/// A text that is left out of the page where it is empty.
data text_or_nothing(const std::string& text);

/// "✓ passed", "✗ failed", ...: status by word and sign, never by colour alone.
std::string status_text(Status status);
Cell status_cell(Status status);

} // namespace settle::compare::report
