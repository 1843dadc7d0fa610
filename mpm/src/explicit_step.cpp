#include "settle/mpm/explicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "constitutive_update.hpp"

namespace settle::mpm {

namespace {

constexpr std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Velocity of a node after the remapping; zero where a support holds.
template <int dim>
Vector<dim> remapped_velocity(const NodeState<dim>& node, const PerAxis<bool, dim>& fixed) {
  Vector<dim> velocity = node.remapped / node.mass;
  for (int d = 0; d < dim; ++d)
    if (fixed[index(d)]) velocity[d] = 0.0;
  return velocity;
}

/// Stiffness of the fastest wave [Pa], the density and the largest normal stress of a cell's points given: M for the
/// law `rate`; M / J + |sigma| for hyperelastic laws, exact for `hencky` in uniaxial strain and a bound for
/// `neo-hookean`.
template <class Grid>
double stiffness(const Body<Grid>& body, double density, double stress) {
  const double modulus = body.lame.constrained_modulus();
  return body.law == exchange::Law::rate ? modulus : modulus * density / body.density + stress;
}

} // namespace

template <class Grid>
double stable_time_step(const Body<Grid>& body, double courant) {
  double slowness_squared = std::numeric_limits<double>::infinity();
  for (const int cell : body.cells.occupied) {
    double mass = 0, volume = 0, stress = 0;
    for (std::size_t p = body.cells.begin[index(cell)]; p < body.cells.begin[index(cell) + 1]; ++p) {
      mass += body.points.mass[p];
      volume += body.points.volume[p];
      for (std::size_t d = 0; d < Grid::dim; ++d)
        stress = std::max(stress, std::abs(body.points.stress[d][p]));
    }
    const double density = mass / std::max(volume, integration_volume(body, volume));
    slowness_squared = std::min(slowness_squared, density / stiffness(body, mass / volume, stress));
  }
  return courant * body.grid.shortest_altitude() * std::sqrt(slowness_squared);
}

template <class Grid>
void scatter_points(const Body<Grid>& body, const Gravity& gravity, Nodes<Grid::dim>& nodes) {
  constexpr int dim = Grid::dim;
  const auto& points = body.points;
  std::fill(nodes.begin(), nodes.end(), NodeState<dim>{});
  for (const int cell : body.cells.occupied) {
    const auto ids = body.grid.nodes(cell);
    const auto stress = average_stress_of(body, cell);
    const typename Grid::Gradients force =
        integration_volume(body, stress.points_volume) * stress.average.tensor * body.grid.gradients(cell);
    for (int i = 0; i < Grid::nodes_per_cell; ++i)
      nodes[index(ids[index(i)])].internal += force.col(i);
    for (std::size_t p = body.cells.begin[index(cell)]; p < body.cells.begin[index(cell) + 1]; ++p) {
      const auto values = body.grid.values(cell, points.position_of(p));
      const double g = gravity.on(points.layer[p]);
      for (std::size_t i = 0; i < ids.size(); ++i) {
        auto& node = nodes[index(ids[i])];
        const double mass = values[i] * points.mass[p];
        node.mass += mass;
        for (std::size_t d = 0; d < dim; ++d)
          node.momentum[static_cast<int>(d)] += mass * points.velocity[d][p];
        node.external[dim - 1] -= mass * g;
      }
    }
  }
}

template <class Grid>
ForceSums update_nodes(const Body<Grid>& body, double damping, Nodes<Grid::dim>& nodes) {
  constexpr int dim = Grid::dim;
  ForceSums sums;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    auto& node = nodes[n];
    if (node.mass == 0.0) continue;
    const Vector<dim> unbalanced = node.external - node.internal;
    sums.external += node.external.template lpNorm<1>();
    if (body.fixed[n][dim - 1]) sums.base_reaction -= unbalanced[dim - 1];
    for (int d = 0; d < dim; ++d) {
      node.acceleration[d] = 0.0;
      if (body.fixed[n][index(d)]) continue;
      sums.unbalanced += std::abs(unbalanced[d]);
      const double against = node.momentum[d] == 0.0 ? 0.0 : std::copysign(1.0, node.momentum[d]);
      node.acceleration[d] = (unbalanced[d] - damping * std::abs(unbalanced[d]) * against) / node.mass;
    }
  }
  return sums;
}

template <class Grid>
void update_velocity_and_remap(Body<Grid>& body, double dt, Nodes<Grid::dim>& nodes) {
  constexpr int dim = Grid::dim;
  auto& points = body.points;
  for (const int cell : body.cells.occupied) {
    const auto ids = body.grid.nodes(cell);
    for (std::size_t p = body.cells.begin[index(cell)]; p < body.cells.begin[index(cell) + 1]; ++p) {
      const auto values = body.grid.values(cell, points.position_of(p));
      Vector<dim> acceleration = Vector<dim>::Zero();
      for (std::size_t i = 0; i < ids.size(); ++i)
        acceleration += values[i] * nodes[index(ids[i])].acceleration;
      Vector<dim> momentum;
      for (int d = 0; d < dim; ++d)
        momentum[d] = points.mass[p] * (points.velocity[index(d)][p] += dt * acceleration[d]);
      for (std::size_t i = 0; i < ids.size(); ++i)
        nodes[index(ids[i])].remapped += values[i] * momentum;
    }
  }
}

template <class Grid>
StepEnergy update_stress_and_move(Body<Grid>& body, const Gravity& gravity, double dt, const Nodes<Grid::dim>& nodes) {
  constexpr int dim = Grid::dim;
  auto& points = body.points;
  StepEnergy energy;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].mass > 0.0)
      energy.kinetic += 0.5 * nodes[n].mass * remapped_velocity<dim>(nodes[n], body.fixed[n]).squaredNorm();
  for (const int cell : body.cells.occupied) {
    const auto ids = body.grid.nodes(cell);
    Eigen::Matrix<double, dim, Grid::nodes_per_cell> displacement;
    for (int i = 0; i < Grid::nodes_per_cell; ++i) {
      const auto n = index(ids[index(i)]);
      displacement.col(i) = dt * remapped_velocity<dim>(nodes[n], body.fixed[n]);
    }
    const Tensor<dim> gradient = displacement * body.grid.gradients(cell).transpose();
    for (std::size_t p = body.cells.begin[index(cell)]; p < body.cells.begin[index(cell) + 1]; ++p) {
      const auto values = body.grid.values(cell, points.position_of(p));
      Vector<dim> move = Vector<dim>::Zero();
      for (int i = 0; i < Grid::nodes_per_cell; ++i)
        move += values[index(i)] * displacement.col(i);
      for (std::size_t d = 0; d < dim; ++d)
        points.position[d][p] += move[static_cast<int>(d)];
      energy.external_work -= points.mass[p] * gravity.on(points.layer[p]) * move[dim - 1];
    }
    deform_points(body, cell, IncrementalKinematics<dim>(gradient), StrainMeasure::midpoint);
  }
  body.sort();
  if (body.average_stress) replace_stress_by_cell_average(body);
  return energy;
}

template double stable_time_step(const Body<TriangleGrid>&, double);
template void scatter_points(const Body<TriangleGrid>&, const Gravity&, Nodes<2>&);
template ForceSums update_nodes(const Body<TriangleGrid>&, double, Nodes<2>&);
template void update_velocity_and_remap(Body<TriangleGrid>&, double, Nodes<2>&);
template StepEnergy update_stress_and_move(Body<TriangleGrid>&, const Gravity&, double, const Nodes<2>&);

} // namespace settle::mpm
