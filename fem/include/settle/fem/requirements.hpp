/// \file
/// What this solver can run: which combinations of a valid case it accepts, and into how many cells it divides the
/// domain.
#pragma once

#include <array>
#include <cstddef>

#include "settle/exchange/case.hpp"

namespace settle::fem {

/// How many cells divide a column along x, y and z (1 in 2-D); the vertical is the last axis of the space.
/// Throws InputError, with the nearest sizes that fit, where layer height, width or depth is no multiple of
/// `fem.element_size`.
[[nodiscard]] std::array<unsigned, 3> cells_along_axes(const exchange::Case& study);

/// How many cells the whole mesh has. Throws InputError where the case cannot be divided into cells.
[[nodiscard]] std::size_t number_of_cells(const exchange::Case& study);

/// Throws InputError where this solver cannot run a case that is valid in itself.
void require_solvable(const exchange::Case& study);

} // namespace settle::fem
