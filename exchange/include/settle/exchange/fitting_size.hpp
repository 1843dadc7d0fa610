/// \file
/// Structured grids need an element size that divides the construction's lengths: the one check both solvers share.
#pragma once

#include <string>

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// How many elements of one size lie along the lengths of a column.
struct ElementCounts {
  int per_layer = 0;
  int across = 0; ///< the width
  int deep = 1;   ///< the depth; 1 in 2-D
};

/// Counts the elements of `size` [m]. Throws InputError, with the sizes next to it that fit, where the height of a
/// layer, the width or the depth is no multiple of it; `key` is the dotted key it was given by, such as
/// "mpm.element_size".
ElementCounts count_elements(const Case& study, const std::string& key, double size);

} // namespace settle::exchange
