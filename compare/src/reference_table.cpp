#include "settle/compare/reference_table.hpp"

#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <tuple>

#include "csv_table.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

using exchange::FileError;

namespace {

enum Column : std::size_t { stage, point, placed_y, y, u_y, sigma_xx, sigma_yy, density, volume, column_count };
constexpr std::array<std::string_view, column_count> column_names{
    "stage", "point", "placed_y_m", "y_m", "u_y_m", "sigma_xx_kPa", "sigma_yy_kPa", "density_kg_m3", "volume_m2"};
constexpr double pascals_per_kilopascal = 1e3;

using Row = std::vector<double>; // one number a column

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
  const std::vector<Row> rows = read_csv(file, column_names, "refilled");
  if (rows.empty())
    throw FileError(
        {.where = file.string(), .what = "the reference table has no rows", .given = {}, .allowed = {}, .remedy = {}});
  ReferenceTable table;
  table.file = file.string();
  std::vector<TablePoint> points;
  for (const Row& row : rows)
    points.push_back({.stage = row[stage], .point = row[point], .placed_height = row[placed_y]});
  append_rows(table, rows, layers_of(points, study, file), study.layer_thickness());
  return table;
}

std::filesystem::path reference_path(const exchange::Case& study, const exchange::Reference& reference) {
  return std::filesystem::path(study.file).parent_path() / reference.file;
}

} // namespace settle::compare
