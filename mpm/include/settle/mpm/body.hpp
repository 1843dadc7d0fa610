/// \file
/// The body under construction: its background grid, its points, its supports.
#pragma once

#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/mpm/cell_table.hpp"
#include "settle/mpm/elasticity.hpp"
#include "settle/mpm/triangle_grid.hpp"

namespace settle::mpm {

/// Gravity as it acts at a moment: full on every layer but the one under construction, whose share grows from 0 to 1.
struct Gravity {
  double acceleration = 9.81; ///< [m/s2], downwards along the last axis
  int ramped_layer = 0;
  double factor = 1.0; ///< of the ramped layer's gravity, 0 ... 1

  [[nodiscard]] double on(int layer) const { return layer == ramped_layer ? factor * acceleration : acceleration; }
};

/// How the internal force is integrated (docs/mpm.md).
enum class StressIntegration {
  full_cells, ///< mixed: the volume-averaged stress over the full volume of every occupied cell
  points      ///< the points' stresses over the points' volumes
};

/// Everything that moves. Changed only at the end of an increment or step, and by placing points.
template <class Grid>
struct Body {
  static constexpr int dim = Grid::dim;

  Grid grid;
  Points<dim> points;
  CellTable cells;
  std::vector<PerAxis<bool, dim>> fixed; ///< per node and direction: displacement prevented
  Lame lame;
  double density = 0; ///< as placed [kg/m3]
  StressIntegration integration = StressIntegration::full_cells;
  bool average_stress = false;             ///< replace point stresses by their cell's average after every move
  exchange::Law law = exchange::Law::rate; ///< `hencky` and `neo-hookean` need points that track their deformation
  bool jaumann = false;                    ///< law `rate`: rotate the stress with the material (Jaumann rate)

  /// Sorts points into cells; to be called after points have moved or were added. Throws PointLost.
  void sort() { sort_by_cell(grid, points, cells); }
};

/// The volume-averaged stress of a cell's points and their volume [m3/m].
template <int dim>
struct CellStress {
  Stress<dim> average;
  double points_volume = 0;
};

template <class Grid>
CellStress<Grid::dim> average_stress_of(const Body<Grid>& body, int cell);

/// The volume over which a cell's average stress acts, its points' volume given [m3/m].
template <class Grid>
double integration_volume(const Body<Grid>& body, double points_volume) {
  return body.integration == StressIntegration::full_cells ? body.grid.cell_volume() : points_volume;
}

/// Replaces the stresses of every cell's points by their volume average.
template <class Grid>
void replace_stress_by_cell_average(Body<Grid>& body);

/// Rollers on both sides and the base: the oedometer.
std::vector<std::array<bool, 2>> oedometer_supports(const TriangleGrid& grid);

/// Sum of all points' masses [kg/m] and of all points' volumes [m3/m] in 2-D.
template <int dim>
double total_mass(const Points<dim>& points);
template <int dim>
double total_volume(const Points<dim>& points);

} // namespace settle::mpm
