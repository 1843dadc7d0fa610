/// \file
/// Figures that are drawn when the page is complete, many at a time.
#pragma once

#include <string>

namespace settle::compare::report {

/// A place in the page where a figure belongs, with all that is needed to draw it. Control characters mark it, which
/// no text of a page has (`printable`). `script`: gnuplot's; `id`: prefix of the figure's own.
std::string to_be_drawn(const std::string& id, const std::string& title, const std::string& script);

/// The page with every such place replaced by its figure, drawn by so many gnuplots at a time. Throws FileError where
/// gnuplot is missing or fails.
std::string with_figures(const std::string& page, int processes);

} // namespace settle::compare::report
