/// \file
/// Reading another code's results from a CSV file.
#pragma once

#include <filesystem>

#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// Reads a table of material points with a header line and the columns stage, point, placed_y_m, y_m, u_y_m,
/// sigma_xx_kPa, sigma_yy_kPa, density_kg_m3, volume_m2, in any order; others are ignored, but rows whose column
/// `refilled` is 1 are left out. Points of one stage and layer placed at one height become one row, averaged by volume.
///
/// A point belongs to the layer that contains its placed height where layers are placed at their design level
/// (`refill`, `drop`), otherwise to the layer of the first stage in which it appears.
/// Throws FileError with file:line where the file cannot be read as such a table.
ReferenceTable read_reference_table(const std::filesystem::path& file, const exchange::Case& study);

/// Where a reference of a case lies: its path relative to the case file's folder.
std::filesystem::path reference_path(const exchange::Case& study, const exchange::Reference& reference);

} // namespace settle::compare
