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

} // namespace

std::string gnuplot_text(const std::string& text) {
  std::string result = "'";
  for (const char c : printable(text)) {
    if (c == '\'') result += '\'';
    result += c == '\n' ? ' ' : c;
  }
  return result + "'";
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
