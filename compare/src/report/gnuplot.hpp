/// \file
/// Figures as SVG, drawn by gnuplot.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "figure_data.hpp"

namespace settle::compare::report {

/// The gnuplot script that draws a figure as SVG, its data inside.
std::string gnuplot_script(const Plot& plot);

/// A text as a gnuplot string: single quotes, in which nothing is substituted.
std::string gnuplot_text(const std::string& text);

/// What a curve is called in the key below a figure: on several rows where it is long.
struct KeyText {
  std::string title; ///< gnuplot's "title ..." of the curve, and an entry without a curve for each further row
  std::size_t rows = 1;
};
KeyText key_text(const std::string& label);

/// The part of a script that all figures share: the terminal, margins, a legend of so many rows below the plot.
/// `left_margin`: room for the height axis [pixels of 540].
std::string gnuplot_canvas(std::size_t legend_rows, int left_margin);

/// Has one gnuplot draw figure after figure (starting it takes longer than drawing one) and returns what it drew, in
/// their order. Throws FileError where gnuplot is missing or fails.
std::vector<std::string> run_gnuplot(const std::vector<std::string>& scripts);

/// gnuplot's SVG made fit to stand inside a page: written anew without ids (svg_shapes.hpp), `title` as its accessible
/// name. One with elements that are not known there is kept, every id prefixed with `prefix` so that no two figures
/// share one, what draws nothing left out. Throws FileError for what is no SVG.
std::string inline_svg(const std::string& svg, const std::string& prefix, const std::string& title);

} // namespace settle::compare::report
