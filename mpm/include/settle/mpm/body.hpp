/// \file
/// The body under construction: its background space, its points, its supports.
#pragma once

#include <functional>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/mpm/cell_table.hpp"
#include "settle/mpm/material.hpp"
#include "settle/mpm/point_layout.hpp"

namespace settle::mpm {

/// On point p, per mass [m/s2].
template <int dim>
using PointForce = std::function<Vector<dim>(const Points<dim>&, std::size_t p)>;

/// Gravity as it acts at a moment: full on every layer but the one under construction, whose share grows from 0 to 1;
/// and what the case's known motion is driven by, or its surface loaded with, besides.
struct Gravity {
  double acceleration = 9.81; ///< [m/s2], downwards along the last axis
  int ramped_layer = 0;
  double factor = 1.0;              ///< of the ramped layer's gravity, 0 ... 1
  PointForce<2> besides{};          ///< in the plane; empty: none
  PointForce<3> besides_in_space{}; ///< likewise; the kernels of the explicit step know none

  [[nodiscard]] double on(int layer) const { return layer == ramped_layer ? factor * acceleration : acceleration; }
  /// All force per mass on point p [m/s2].
  template <int dim>
  [[nodiscard]] Vector<dim> pull(const Points<dim>& points, std::size_t p) const {
    Vector<dim> pull = Vector<dim>::Zero();
    pull[dim - 1] = -on(points.layer[p]);
    if constexpr (dim == 2) {
      if (besides) pull += besides(points, p);
    } else {
      if (besides_in_space) pull += besides_in_space(points, p);
    }
    return pull;
  }
};

/// How the internal force is integrated (docs/mpm.md).
enum class StressIntegration {
  full_cells, ///< mixed: the points of every occupied cell share its full volume
  points      ///< the points' stresses over the points' volumes
};

/// Everything that moves. Changed only at the end of an increment or step, and by placing points.
template <class Space>
struct Body {
  static constexpr int dim = Space::dim;

  Space space;
  Points<dim> points;
  PointLayout<dim> layout; ///< how points are placed
  CellTable cells;
  std::vector<PerAxis<bool, dim>> fixed; ///< per node and direction: displacement prevented
  Lame lame;
  double density = 0; ///< as placed [kg/m3]
  StressIntegration integration = StressIntegration::full_cells;
  bool average_stress = false;             ///< replace point stresses by their cell's average after every move
  exchange::Law law = exchange::Law::rate; ///< `hencky` and `neo-hookean` need points that track their deformation
  bool jaumann = false;                    ///< law `rate` and soils: rotate the stress with the material (Jaumann rate)
  /// Of layers 1, 2, ... where they differ or are soils; empty: all are of `law`, `lame` and `density`.
  std::vector<Material> materials{};
  /// Volumetric strain and mean stress are those of the cell: material that yields at constant volume does not lock
  /// (docs/mpm.md). For `full_cells`.
  bool mean_volume = false;

  [[nodiscard]] const Material& material_of(int layer) const { return materials[static_cast<std::size_t>(layer - 1)]; }
  /// As placed [kg/m3].
  [[nodiscard]] double density_of(int layer) const { return materials.empty() ? density : material_of(layer).density; }
  /// As placed [Pa]; 0 where the law knows none.
  [[nodiscard]] double preconsolidation_of(int layer) const {
    return materials.empty() ? 0.0 : material_of(layer).preconsolidation_pressure();
  }

  /// Sorts points into cells; to be called after points have moved or were added. Throws PointLost.
  void sort() { sort_by_cell(space, points, cells); }
};

/// A range of the sorted points.
struct PointRange {
  std::size_t first = 0, last = 0; ///< first ... last - 1
};
template <class Space>
PointRange points_in(const Body<Space>& body, int cell) {
  const auto c = static_cast<std::size_t>(cell);
  return {body.cells.begin[c], body.cells.begin[c + 1]};
}

/// The volume-averaged stress of some points and their volume [m3/m].
template <int dim>
struct AverageStress {
  Stress<dim> average;
  double points_volume = 0;
};

template <int dim>
AverageStress<dim> average_stress_of(const Points<dim>& points, PointRange range) {
  AverageStress<dim> result;
  std::array<double, stress_size<dim>> sum{};
  for (std::size_t p = range.first; p < range.last; ++p) {
    const double v = points.volume[p];
    result.points_volume += v;
    for (std::size_t c = 0; c < sum.size(); ++c)
      sum[c] += v * points.stress[c][p];
  }
  result.average = stress_of_components<dim>([&](std::size_t c) { return sum[c] / result.points_volume; });
  return result;
}

/// The volume over which the stress of a cell acts, its points' volume given [m3/m].
template <class Space>
double integration_volume(const Body<Space>& body, double points_volume) {
  return body.integration == StressIntegration::full_cells ? body.space.cell_volume() : points_volume;
}

/// Replaces the stresses of every cell's points by their volume average.
template <class Space>
void replace_stress_by_cell_average(Body<Space>& body);

/// Rollers on all sides and the base: the oedometer.
template <class Space>
std::vector<PerAxis<bool, Space::dim>> oedometer_supports(const Space& space);

/// Sum of all points' masses [kg/m in 2-D] and of all points' volumes [m3/m in 2-D].
template <int dim>
double total_mass(const Points<dim>& points);
template <int dim>
double total_volume(const Points<dim>& points);

} // namespace settle::mpm
