/// \file
/// What many drawings of a page have in common.
#pragma once

#include <string>

namespace settle::compare::report {

/// Has axes, grids, words and curves that three or more drawings of a page hold alike stand in it once, behind
/// `<body>`, and each drawing refer to them. Drawings are the SVGs of figures and charts: paths, texts, and groups of
/// texts; one that holds anything else stays as it is. What is shared takes fill and font from the drawing it is in.
std::string with_shared_shapes(const std::string& page);

} // namespace settle::compare::report
