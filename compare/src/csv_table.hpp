/// \file
/// Tables of numbers in CSV files: a header line with names, then rows.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::compare {

/// The rows of a table, each with one number for each name asked for, in the order of the names; lines without text are
/// skipped, and so are rows whose column `left_out`, if there is one, is not zero. Other columns are not looked at.
/// Throws FileError with file:line where the file cannot be read, a column is missing (all are named), a row has
/// another number of cells than the header, or a cell is no finite number.
std::vector<std::vector<double>> read_csv(const std::filesystem::path& file, std::span<const std::string_view> names,
                                          std::string_view left_out);

/// Has the table's header line a column of that name? False where the file cannot be read.
bool has_column(const std::filesystem::path& file, std::string_view name);

/// A material point of a table at one stage.
struct TablePoint {
  double stage = 0, point = 0;
  double placed_height = 0; ///< [m]
};

/// The layer of each point: by its placed height where layers are placed at their design level (`refill`, `drop`),
/// otherwise the first stage in which the point appears. Throws FileError where a point lies in a layer that its stage
/// has not reached.
std::vector<int> layers_of(const std::vector<TablePoint>& points, const exchange::Case& study,
                           const std::filesystem::path& file);

} // namespace settle::compare
