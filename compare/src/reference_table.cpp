#include "settle/compare/reference_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/exchange/errors.hpp"

namespace settle::compare {

using exchange::Convention;
using exchange::FileError;

namespace {

enum Column : std::size_t { stage, point, placed_y, y, u_y, sigma_xx, sigma_yy, density, volume, column_count };
constexpr std::array<std::string_view, column_count> column_names{
    "stage", "point", "placed_y_m", "y_m", "u_y_m", "sigma_xx_kPa", "sigma_yy_kPa", "density_kg_m3", "volume_m2"};
constexpr double pascals_per_kilopascal = 1e3;

using Row = std::array<double, column_count>;

std::vector<std::string> split(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  std::vector<std::string> cells;
  while (true) {
    const std::size_t comma = line.find(',');
    cells.emplace_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

/// Where the columns stand in the file.
struct Header {
  std::array<std::size_t, column_count> position{};
  std::size_t cells = 0;
  std::size_t refilled = 0; ///< `cells` where there is no such column
};

Header read_header(const std::string& line, const std::string& file) {
  const std::vector<std::string> cells = split(line);
  Header header{.cells = cells.size()};
  const auto find = [&](std::string_view name) {
    return static_cast<std::size_t>(std::find(cells.begin(), cells.end(), name) - cells.begin());
  };
  for (std::size_t c = 0; c < column_count; ++c) {
    header.position[c] = find(column_names[c]);
    if (header.position[c] == cells.size()) {
      throw FileError({.where = file + ":1",
                       .what = fmt::format("the column \"{}\" is missing", column_names[c]),
                       .given = line,
                       .allowed = fmt::format("{}", fmt::join(column_names, ",")),
                       .remedy = {}});
    }
  }
  header.refilled = find("refilled");
  return header;
}

double to_number(const std::string& cell, const std::string& where) {
  double number = 0.0;
  const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  if (problem != std::errc() || end != cell.data() + cell.size() || !std::isfinite(number)) {
    throw FileError(
        {.where = where, .what = "not a number", .given = cell, .allowed = "a finite number", .remedy = {}});
  }
  return number;
}

std::vector<Row> read_rows(std::istream& input, const std::string& file) {
  std::string line;
  std::getline(input, line);
  const Header header = read_header(line, file);
  std::vector<Row> rows;
  for (int number = 2; std::getline(input, line); ++number) {
    if (line.empty()) continue;
    const std::string where = fmt::format("{}:{}", file, number);
    const std::vector<std::string> cells = split(line);
    if (cells.size() != header.cells) {
      throw FileError({.where = where,
                       .what = fmt::format("{} cells instead of {}", cells.size(), header.cells),
                       .given = line,
                       .allowed = {},
                       .remedy = {}});
    }
    if (header.refilled < header.cells && to_number(cells[header.refilled], where) != 0.0) continue;
    Row row{};
    for (std::size_t c = 0; c < column_count; ++c)
      row[c] = to_number(cells[header.position[c]], where);
    rows.push_back(row);
  }
  return rows;
}

/// The layer of every row, or FileError where a point lies in a layer that its stage has not reached.
std::vector<int> layers_of(const std::vector<Row>& rows, const exchange::Case& study, const std::string& file) {
  const Convention convention = study.construction.convention;
  const bool by_height = convention == Convention::refill || convention == Convention::drop;
  std::map<double, double> first_stage;
  for (const Row& row : rows) {
    const auto known = first_stage.try_emplace(row[point], row[stage]).first;
    known->second = std::min(known->second, row[stage]);
  }
  std::vector<int> layers;
  for (const Row& row : rows) {
    const double layer = by_height ? std::ceil(row[placed_y] / study.layer_thickness()) : first_stage.at(row[point]);
    if (!(layer >= 1.0) || layer > row[stage] || row[stage] > study.construction.layers) {
      throw FileError(
          {.where = file,
           .what = "the table does not belong to this case",
           .given = fmt::format("point {} at stage {}, placed at {} m", row[point], row[stage], row[placed_y]),
           .allowed = fmt::format("{} layers of {} m, a point in a layer already placed", study.construction.layers,
                                  study.layer_thickness()),
           .remedy = "compare the table with a case of the same geometry and layers"});
    }
    layers.push_back(static_cast<int>(layer));
  }
  return layers;
}

/// Sums of the points of one row of the table, weighted by volume.
struct Sums {
  int points = 0;
  double volume = 0, mass = 0, height = 0, displacement = 0, vertical = 0, lateral = 0;

  void add(const Row& row) {
    const double v = row[Column::volume];
    ++points;
    volume += v;
    mass += v * row[density];
    height += v * row[placed_y];
    displacement += v * row[u_y];
    vertical += v * row[sigma_yy];
    lateral += v * row[sigma_xx];
  }
};

void append(ReferenceTable& table, int at_stage, int layer, const Sums& sums) {
  table.stage.push_back(at_stage);
  table.layer.push_back(layer);
  table.points.push_back(sums.points);
  table.placed_height.push_back(sums.height / sums.volume);
  table.settlement.push_back(-sums.displacement / sums.volume);
  table.vertical_stress.push_back(pascals_per_kilopascal * sums.vertical / sums.volume);
  table.lateral_stress.push_back(pascals_per_kilopascal * sums.lateral / sums.volume);
  table.density.push_back(sums.mass / sums.volume);
  table.volume.push_back(sums.volume);
}

/// Heights are printed with 8 digits and rows of points lie 1e-3 t apart or more: 1e-4 t tells them apart.
void append_rows(ReferenceTable& table, const std::vector<Row>& rows, const std::vector<int>& layers,
                 double thickness) {
  std::map<std::tuple<int, int, long long>, Sums> groups;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const long long height = std::llround(rows[i][placed_y] / (1e-4 * thickness));
    groups[{static_cast<int>(rows[i][stage]), layers[i], height}].add(rows[i]);
  }
  for (const auto& [key, sums] : groups)
    append(table, std::get<0>(key), std::get<1>(key), sums);
}

} // namespace

ReferenceTable read_reference_table(const std::filesystem::path& file, const exchange::Case& study) {
  std::ifstream input(file);
  if (!input)
    throw FileError({.where = file.string(),
                     .what = "the reference table cannot be read",
                     .given = {},
                     .allowed = {},
                     .remedy = "check the path in [reference]; it is relative to the case file"});
  const std::vector<Row> rows = read_rows(input, file.string());
  if (rows.empty())
    throw FileError(
        {.where = file.string(), .what = "the reference table has no rows", .given = {}, .allowed = {}, .remedy = {}});
  ReferenceTable table;
  table.file = file.string();
  append_rows(table, rows, layers_of(rows, study, file.string()), study.layer_thickness());
  return table;
}

std::filesystem::path reference_path(const exchange::Case& study, const exchange::Reference& reference) {
  return std::filesystem::path(study.file).parent_path() / reference.file;
}

} // namespace settle::compare
