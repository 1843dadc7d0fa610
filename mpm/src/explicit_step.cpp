#include "settle/mpm/explicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "cell_gradients.hpp"
#include "constitutive_update.hpp"
#include "settle/mpm/spaces.hpp"

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

/// Every node's displacement in the step from its remapped velocity; the nodes' kinetic energy [J/m].
template <class Space>
double move_nodes(const Body<Space>& body, double dt, Nodes<Space::dim>& nodes) {
  constexpr int dim = Space::dim;
  double kinetic = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (!(nodes[n].mass > 0.0)) continue;
    const Vector<dim> velocity = remapped_velocity<dim>(nodes[n], body.fixed[n]);
    nodes[n].displacement = dt * velocity;
    kinetic += 0.5 * nodes[n].mass * velocity.squaredNorm();
  }
  return kinetic;
}

/// Stiffness of the fastest wave [Pa], the density and the largest normal stress of a cell's points given: M for the
/// law `rate`; M / J + |sigma| for hyperelastic laws, exact for `hencky` in uniaxial strain and a bound for
/// `neo-hookean`.
template <class Space>
double stiffness(const Body<Space>& body, double density, double stress) {
  const double modulus = body.lame.constrained_modulus();
  return body.law == exchange::Law::rate ? modulus : modulus * density / body.density + stress;
}

template <class Space>
void scatter_internal_force(const Body<Space>& body, int cell, Nodes<Space::dim>& nodes) {
  const CellGradients<Space> cell_gradients(body, cell);
  cell_gradients.for_each_patch([&](const Patch<Space>& patch) {
    const auto stress = average_stress_of(body.points, patch.points);
    const typename Space::Stencil::Gradients force = patch.volume * stress.average.tensor * patch.gradients;
    for (int i = 0; i < cell_gradients.n_nodes(); ++i)
      nodes[index(cell_gradients.node(i))].internal += force.col(i);
  });
}

/// Moves a point with the nodes; the work of its weight on the way [J/m].
template <class Space>
double move_point(Body<Space>& body, int cell, std::size_t p, const Gravity& gravity, const Nodes<Space::dim>& nodes) {
  constexpr int dim = Space::dim;
  auto& points = body.points;
  const auto stencil = body.space.stencil(cell, points, p);
  Vector<dim> move = Vector<dim>::Zero();
  for (int i = 0; i < stencil.size(); ++i)
    move += stencil.value(i) * nodes[index(stencil.node(i))].displacement;
  for (std::size_t d = 0; d < dim; ++d)
    points.position[d][p] += move[static_cast<int>(d)];
  return points.mass[p] * gravity.pull(points, p).dot(move);
}

} // namespace

template <class Space>
double stable_time_step(const Body<Space>& body, double courant) {
  double slowness_squared = std::numeric_limits<double>::infinity();
  for (const int cell : body.cells.occupied) {
    double mass = 0, volume = 0, stress = 0;
    const auto [first, last] = points_in(body, cell);
    for (std::size_t p = first; p < last; ++p) {
      mass += body.points.mass[p];
      volume += body.points.volume[p];
      for (std::size_t d = 0; d < Space::dim; ++d)
        stress = std::max(stress, std::abs(body.points.stress[d][p]));
    }
    const double density = mass / std::max(volume, integration_volume(body, volume));
    slowness_squared = std::min(slowness_squared, density / stiffness(body, mass / volume, stress));
  }
  return courant * body.space.shortest_length() * std::sqrt(slowness_squared);
}

template <class Space>
void scatter_points(const Body<Space>& body, const Gravity& gravity, Nodes<Space::dim>& nodes) {
  constexpr int dim = Space::dim;
  const auto& points = body.points;
  std::fill(nodes.begin(), nodes.end(), NodeState<dim>{});
  for (const int cell : body.cells.occupied) {
    scatter_internal_force(body, cell, nodes);
    const auto [first, last] = points_in(body, cell);
    for (std::size_t p = first; p < last; ++p) {
      const auto stencil = body.space.stencil(cell, points, p);
      const Vector<dim> pull = gravity.pull(points, p);
      for (int i = 0; i < stencil.size(); ++i) {
        auto& node = nodes[index(stencil.node(i))];
        const double mass = stencil.value(i) * points.mass[p];
        node.mass += mass;
        for (std::size_t d = 0; d < dim; ++d)
          node.momentum[static_cast<int>(d)] += mass * points.velocity[d][p];
        node.external += mass * pull;
      }
    }
  }
}

template <class Space>
ForceSums update_nodes(const Body<Space>& body, double damping, Nodes<Space::dim>& nodes) {
  constexpr int dim = Space::dim;
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

template <class Space>
void update_velocity_and_remap(Body<Space>& body, double dt, Nodes<Space::dim>& nodes) {
  constexpr int dim = Space::dim;
  auto& points = body.points;
  for (const int cell : body.cells.occupied) {
    const auto [first, last] = points_in(body, cell);
    for (std::size_t p = first; p < last; ++p) {
      const auto stencil = body.space.stencil(cell, points, p);
      Vector<dim> acceleration = Vector<dim>::Zero();
      for (int i = 0; i < stencil.size(); ++i)
        acceleration += stencil.value(i) * nodes[index(stencil.node(i))].acceleration;
      Vector<dim> momentum;
      for (int d = 0; d < dim; ++d)
        momentum[d] = points.mass[p] * (points.velocity[index(d)][p] += dt * acceleration[d]);
      for (int i = 0; i < stencil.size(); ++i)
        nodes[index(stencil.node(i))].remapped += stencil.value(i) * momentum;
    }
  }
}

template <class Space>
StepEnergy update_stress_and_move(Body<Space>& body, const Gravity& gravity, double dt, Nodes<Space::dim>& nodes) {
  constexpr int dim = Space::dim;
  StepEnergy energy{.kinetic = move_nodes(body, dt, nodes)};
  for (const int cell : body.cells.occupied) {
    const CellGradients<Space> cell_gradients(body, cell);
    cell_gradients.for_each_patch([&](const Patch<Space>& patch) {
      Tensor<dim> gradient = Tensor<dim>::Zero();
      for (int i = 0; i < cell_gradients.n_nodes(); ++i)
        gradient += nodes[index(cell_gradients.node(i))].displacement * patch.gradients.col(i).transpose();
      for (std::size_t p = patch.points.first; p < patch.points.last; ++p)
        energy.external_work += move_point(body, cell, p, gravity, nodes);
      deform_points(body, patch.points, IncrementalKinematics<dim>(gradient), StrainMeasure::midpoint);
    });
  }
  body.sort();
  if (body.average_stress) replace_stress_by_cell_average(body);
  return energy;
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template double stable_time_step(const Body<Space>&, double);                                                        \
  template void scatter_points(const Body<Space>&, const Gravity&, Nodes<Space::dim>&);                                \
  template ForceSums update_nodes(const Body<Space>&, double, Nodes<Space::dim>&);                                     \
  template void update_velocity_and_remap(Body<Space>&, double, Nodes<Space::dim>&);                                   \
  template StepEnergy update_stress_and_move(Body<Space>&, const Gravity&, double, Nodes<Space::dim>&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
