/// \file
/// What this solver can run: which combinations of a valid case it accepts, and how its cells divide the domain.
#pragma once

#include <array>

#include "settle/exchange/case.hpp"

namespace settle::fem {

/// How many cells divide the domain.
struct CellCounts {
  std::array<unsigned, 3> along{1, 1, 1}; ///< along x, y and z; z counts only in 3-D; the last axis is the vertical
  unsigned per_layer = 1;                 ///< cells over the height of one layer
};

/// Cells along each axis for `fem.element_size`.
/// Throws InputError, with the nearest sizes that fit, where layer height, width or depth is no multiple of it.
CellCounts cell_counts(const exchange::Case& study);

/// Throws InputError where this solver cannot run a case that is valid in itself.
void require_solvable(const exchange::Case& study);

} // namespace settle::fem
