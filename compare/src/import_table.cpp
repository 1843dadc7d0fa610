#include "settle/compare/import_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "csv_table.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {

using exchange::FileError;
using exchange::Stage;

namespace {

enum Column : std::size_t {
  stage,
  point,
  placed_x,
  placed_y,
  x,
  y,
  u_x,
  u_y,
  sigma_xx,
  sigma_yy,
  sigma_zz,
  sigma_xy,
  density,
  volume,
  reaction,
  refilled
};
// The last one may be left out.
constexpr std::array<std::string_view, refilled + 1> column_names{
    "stage",         "point",     "placed_x_m",        "placed_y_m",   "x_m",          "y_m",
    "u_x_m",         "u_y_m",     "sigma_xx_kPa",      "sigma_yy_kPa", "sigma_zz_kPa", "sigma_xy_kPa",
    "density_kg_m3", "volume_m2", "base_reaction_N_m", "refilled"};
constexpr double pascals_per_kilopascal = 1e3;

using Row = std::vector<double>;

[[noreturn]] void complain(const std::filesystem::path& file, const std::string& what, const std::string& given,
                           const std::string& allowed) {
  throw FileError({.where = file.string(), .what = what, .given = given, .allowed = allowed, .remedy = {}});
}

std::vector<Row> read_points(const std::filesystem::path& file) {
  const std::size_t count = has_column(file, column_names.back()) ? column_names.size() : column_names.size() - 1;
  std::vector<Row> rows = read_csv(file, std::span(column_names).first(count), "");
  for (Row& row : rows)
    row.resize(column_names.size(), 0.0);
  if (rows.empty()) complain(file, "the table has no rows", {}, {});
  return rows;
}

/// What is known of all points while stages are read one after another.
class Points {
public:
  explicit Points(const std::filesystem::path& file) : file_(file) {}

  /// Mass of a point [kg/m], which it keeps. `is_new`: it has not been seen at an earlier stage.
  double mass_of(const Row& row, bool& is_new) {
    const double here = row[density] * row[volume];
    const auto [known, first] = masses_.try_emplace(row[point], here);
    is_new = first;
    constexpr double digits_of_a_table = 1e-6;
    if (!(std::abs(here - known->second) <= digits_of_a_table * known->second))
      complain(file_, fmt::format("point {} does not keep its mass", row[point]),
               fmt::format("density x volume {:.9g} kg/m at stage {}", here, row[stage]),
               fmt::format("{:.9g} kg/m, with which it first appeared", known->second));
    return known->second;
  }

private:
  const std::filesystem::path& file_;
  std::map<double, double> masses_;
};

void append(const Row& row, int layer, double mass, exchange::SamplePoints& points) {
  points.id.push_back(static_cast<std::uint64_t>(row[point]));
  points.layer.push_back(layer);
  points.refilled.push_back(row[refilled] != 0.0 ? 1 : 0);
  points.placed_position.insert(points.placed_position.end(), {row[placed_x], row[placed_y]});
  points.position.insert(points.position.end(), {row[x], row[y]});
  points.displacement.insert(points.displacement.end(), {row[u_x], row[u_y]});
  for (const double value : {row[sigma_xx], row[sigma_yy], row[sigma_zz], row[sigma_xy], 0.0, 0.0})
    points.stress.push_back(pascals_per_kilopascal * value);
  points.density.push_back(row[density]);
  points.volume.push_back(mass / row[density]);
}

/// Weight, equilibrium and surface of a stage whose points and masses are there.
void balance(const exchange::Case& study, Stage& done) {
  done.weight = study.gravity * done.mass;
  done.out_of_balance = std::abs(done.base_reaction - done.weight) / done.weight;
  done.in_equilibrium = done.out_of_balance <= study.mpm.explicit_dynamic.force_error;
  const std::vector<double>& volumes = done.points.volume;
  done.surface_height = std::accumulate(volumes.begin(), volumes.end(), 0.0) / study.geometry.width;
}

} // namespace

std::vector<Stage> import_stages(const std::filesystem::path& table, const exchange::Case& study) {
  if (study.geometry.dimension != 2) {
    throw exchange::InputError({.where = study.where("geometry.dimension"),
                                .what = "a table of points is of a 2-D case",
                                .given = fmt::format("{}", study.geometry.dimension),
                                .allowed = "2",
                                .remedy = "write a result file (docs/adding-a-solver.md)"});
  }
  const std::vector<Row> rows = read_points(table);
  std::vector<TablePoint> places;
  for (const Row& row : rows)
    places.push_back({.stage = row[stage], .point = row[point], .placed_height = row[placed_y]});
  const std::vector<int> layers = layers_of(places, study, table);
  std::vector<Stage> stages(static_cast<std::size_t>(study.n_stages()));
  Points known(table);
  for (std::size_t k = 0; k < stages.size(); ++k) {
    Stage& done = stages[k];
    done.layer = study.layer_of_stage(static_cast<int>(k) + 1);
    done.mass = k > 0 ? stages[k - 1].mass : 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i][stage] != static_cast<double>(k + 1)) continue;
      bool is_new = false;
      const double mass = known.mass_of(rows[i], is_new);
      if (is_new) (rows[i][refilled] != 0.0 ? done.mass_refilled : done.mass_placed) += mass;
      append(rows[i], layers[i], mass, done.points);
      done.base_reaction = rows[i][reaction];
    }
    if (done.points.size() == 0)
      complain(table, fmt::format("stage {} has no points", k + 1), {},
               fmt::format("stages 1 to {}", study.construction.layers));
    done.mass += done.mass_placed + done.mass_refilled;
    balance(study, done);
  }
  return stages;
}

} // namespace settle::compare
