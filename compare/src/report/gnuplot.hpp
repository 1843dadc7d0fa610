/// \file
/// Figures as SVG, drawn by gnuplot.
#pragma once

#include <string>

#include "figure_data.hpp"

namespace settle::compare::report {

/// The gnuplot script that draws a figure as SVG, its data inside.
std::string gnuplot_script(const Plot& plot);

/// Runs gnuplot on a script and returns what it drew. Throws FileError where gnuplot is missing or fails.
std::string run_gnuplot(const std::string& script);

/// gnuplot's SVG made fit to stand inside a page: no XML header, `title` as its accessible name, every id prefixed with
/// `prefix` so that no two figures share one, what draws nothing left out. Throws FileError for what is no SVG.
std::string inline_svg(const std::string& svg, const std::string& prefix, const std::string& title);

} // namespace settle::compare::report
