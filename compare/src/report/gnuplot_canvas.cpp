#include <algorithm>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "format.hpp"
#include "gnuplot.hpp"

namespace settle::compare::report {

namespace {

// Pixels of the drawing. Narrow, with large letters, so that it is still readable on a phone.
constexpr int width = 540;
constexpr int plot_height = 430;
constexpr int right_margin = 18;
constexpr int top_margin = 12;
constexpr int axis_space = 74; // ticks and title below the plot
constexpr int legend_row = 22;
constexpr int font_size = 15;

constexpr std::size_t longest_row = 54; // letters: 540 pixels less the sample of the curve, 8 pixels each

/// Letters, not bytes.
std::size_t letters_in(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

/// Broken at blanks; a word that is too long stays whole.
std::vector<std::string> rows_of(const std::string& text) {
  std::vector<std::string> rows{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    std::string& row = rows.back();
    if (row.empty())
      row = word;
    else if (letters_in(row) + 1 + letters_in(word) <= longest_row)
      row += " " + word;
    else
      rows.push_back(word);
  }
  return rows;
}

} // namespace

std::string gnuplot_text(const std::string& text) {
  std::string result = "'";
  for (const char c : printable(text)) {
    if (c == '\'') result += '\'';
    result += c == '\n' ? ' ' : c;
  }
  return result + "'";
}

KeyText key_text(const std::string& label) {
  const std::vector<std::string> rows = rows_of(printable(label));
  KeyText text{.title = "title " + gnuplot_text(rows.front()), .rows = rows.size()};
  for (std::size_t i = 1; i < rows.size(); ++i)
    text.title += ", keyentry title " + gnuplot_text("   " + rows[i]);
  return text;
}

std::string gnuplot_canvas(std::size_t legend_rows, int left_margin) {
  const int below = axis_space + legend_row * static_cast<int>(legend_rows) + 8;
  const int height = top_margin + plot_height + below;
  const double legend_top = static_cast<double>(below - axis_space) / height;
  return fmt::format("set encoding utf8\n"
                     "set terminal svg size {},{} dynamic noenhanced font 'sans-serif,{}'\n"
                     "set margins screen {:.5f}, screen {:.5f}, screen {:.5f}, screen {:.5f}\n"
                     "set key at screen 0.02, screen {:.5f} left top vertical Left reverse samplen 2.4 width 0\n",
                     width, height, font_size, static_cast<double>(left_margin) / width,
                     1.0 - static_cast<double>(right_margin) / width, static_cast<double>(below) / height,
                     1.0 - static_cast<double>(top_margin) / height, legend_top);
}

} // namespace settle::compare::report
