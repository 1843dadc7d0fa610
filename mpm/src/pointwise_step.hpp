/// \file
/// The explicit step point by point, for any space: slow, and what the kernels are tested against.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "cell_gradients.hpp"
#include "constitutive_update.hpp"
#include "mean_volume.hpp"
#include "settle/mpm/explicit_step.hpp"
#include "settle/mpm/placement.hpp"

namespace settle::mpm {

/// The phases of ExplicitStep.
template <class Space>
class PointwiseStep {
public:
  static constexpr int dim = Space::dim;

  explicit PointwiseStep(Body<Space>& body, int /*threads*/ = 1)
      : body_(body), nodes_(static_cast<std::size_t>(body.space.n_nodes())), remapped_(nodes_.size()) {}

  void scatter(const Gravity& gravity) {
    std::fill(nodes_.begin(), nodes_.end(), NodeState<dim>{});
    for (const int cell : body_.cells.occupied) {
      scatter_internal_force(cell);
      for_each_point(cell, [&](std::size_t p, const Stencil& stencil) {
        const Vector<dim> pull = gravity.pull(body_.points, p);
        for (int i = 0; i < stencil.size(); ++i) {
          auto& node = at(stencil.node(i));
          const double mass = stencil.value(i) * body_.points.mass[p];
          node.mass += mass;
          for (int d = 0; d < dim; ++d)
            node.momentum[d] += mass * velocity(d, p);
          node.external += mass * pull;
        }
      });
    }
  }

  [[nodiscard]] double stable_time_step(double courant) const {
    double slowness_squared = std::numeric_limits<double>::infinity();
    for (const int cell : body_.cells.occupied) {
      double mass = 0, volume = 0, stress = 0;
      const PointRange range = points_in(body_, cell);
      for (std::size_t p = range.first; p < range.last; ++p) {
        mass += body_.points.mass[p];
        volume += body_.points.volume[p];
        for (std::size_t d = 0; d < dim; ++d)
          stress = std::max(stress, std::abs(body_.points.stress[d][p]));
      }
      const double density = mass / std::max(volume, integration_volume(body_, volume));
      slowness_squared = std::min(slowness_squared, density / stiffness(range, mass / volume, stress));
    }
    return courant * body_.space.shortest_length() * std::sqrt(slowness_squared);
  }

  [[nodiscard]] std::vector<double> column_heights() const { return mpm::column_heights(body_); }

  ForceSums accelerate(double damping) {
    ForceSums sums;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      auto& node = nodes_[n];
      if (node.mass == 0.0) continue;
      const Vector<dim> unbalanced = node.external - node.internal;
      sums.external += node.external.template lpNorm<1>();
      if (body_.fixed[n][dim - 1]) sums.base_reaction -= unbalanced[dim - 1];
      for (int d = 0; d < dim; ++d) {
        if (body_.fixed[n][static_cast<std::size_t>(d)]) continue;
        sums.unbalanced += std::abs(unbalanced[d]);
        const double against = node.momentum[d] == 0.0 ? 0.0 : std::copysign(1.0, node.momentum[d]);
        node.acceleration[d] = (unbalanced[d] - damping * std::abs(unbalanced[d]) * against) / node.mass;
      }
    }
    return sums;
  }

  /// The points' velocities change here, and their momenta are mapped back.
  StepEnergy displace(double kick, double dt, double kept = 1.0) {
    std::fill(remapped_.begin(), remapped_.end(), Vector<dim>::Zero().eval());
    for (const int cell : body_.cells.occupied)
      for_each_point(cell, [&](std::size_t p, const Stencil& stencil) {
        Vector<dim> acceleration = Vector<dim>::Zero(), momentum;
        for (int i = 0; i < stencil.size(); ++i)
          acceleration += stencil.value(i) * at(stencil.node(i)).acceleration;
        for (int d = 0; d < dim; ++d) {
          momentum[d] = body_.points.mass[p] * (velocity(d, p) += kick * acceleration[d]);
          velocity(d, p) *= kept;
        }
        for (int i = 0; i < stencil.size(); ++i)
          remapped_[static_cast<std::size_t>(stencil.node(i))] += stencil.value(i) * momentum;
      });
    StepEnergy energy;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      auto& node = nodes_[n];
      if (!(node.mass > 0.0)) continue;
      Vector<dim> velocity = remapped_[n] / node.mass;
      for (int d = 0; d < dim; ++d)
        if (body_.fixed[n][static_cast<std::size_t>(d)]) velocity[d] = 0.0;
      node.displacement = dt * velocity;
      energy.kinetic += 0.5 * node.mass * velocity.squaredNorm();
      energy.external_work += node.external.dot(node.displacement);
    }
    return energy;
  }

  void move() {
    for (const int cell : body_.cells.occupied) {
      const CellGradients<Space> cell_gradients(body_, cell);
      cell_gradients.for_each_patch([&](const Patch<Space>& patch) {
        Tensor<dim> gradient = gradient_of(cell_gradients, patch.gradients);
        if (body_.mean_volume)
          gradient = with_volume_of<dim>(gradient, gradient_of(cell_gradients, cell_gradients.mean_gradients()));
        for (std::size_t p = patch.points.first; p < patch.points.last; ++p)
          move_point(cell, p);
        deform_points(body_, patch.points, IncrementalKinematics<dim>(gradient), StrainMeasure::midpoint);
      });
    }
    body_.sort();
    if (body_.average_stress) replace_stress_by_cell_average(body_);
  }

  void gather() {}

  [[nodiscard]] NodeState<dim> node(int node) const { return nodes_[static_cast<std::size_t>(node)]; }
  void read_nodes(Nodes<dim>& nodes) const { nodes = nodes_; }
  void set_displacement(int node, const Vector<dim>& displacement) { at(node).displacement = displacement; }

private:
  using Stencil = typename Space::Stencil;

  Body<Space>& body_;
  std::vector<NodeState<dim>> nodes_;
  std::vector<Vector<dim>> remapped_; ///< momentum

  NodeState<dim>& at(int node) { return nodes_[static_cast<std::size_t>(node)]; }
  double& velocity(int d, std::size_t p) { return body_.points.velocity[static_cast<std::size_t>(d)][p]; }

  template <class Action>
  void for_each_point(int cell, Action&& action) {
    const auto [first, last] = points_in(body_, cell);
    for (std::size_t p = first; p < last; ++p)
      action(p, body_.space.stencil(cell, body_.points, p));
  }

  /// Stiffness of the fastest wave [Pa], the density and the largest normal stress of a cell's points given: M for the
  /// law `rate` and soils, by the stress of each point; M / J + |sigma| for hyperelastic laws, exact for `hencky` in
  /// uniaxial strain and a bound for `neo-hookean`.
  [[nodiscard]] double stiffness(PointRange range, double density, double stress) const {
    if (body_.materials.empty()) {
      const double modulus = body_.lame.constrained_modulus();
      return body_.law == exchange::Law::rate ? modulus : modulus * density / body_.density + stress;
    }
    double largest = 0;
    for (std::size_t p = range.first; p < range.last; ++p) {
      const Material& material = body_.material_of(body_.points.layer[p]);
      const double modulus = material.constrained_modulus(soil::six_of(stress_of(body_.points, p)));
      largest = std::max(largest, material.is_hyperelastic() ? modulus * density / material.density + stress : modulus);
    }
    return largest;
  }

  void scatter_internal_force(int cell) {
    const CellGradients<Space> cell_gradients(body_, cell);
    cell_gradients.for_each_patch([&](const Patch<Space>& patch) {
      const auto stress = average_stress_of(body_.points, patch.points);
      const Tensor<dim> pull = patch.volume * stress.average.tensor;
      typename Stencil::Gradients force = pull * patch.gradients;
      if (body_.mean_volume) force = split_traction<Space>(pull, patch.gradients, cell_gradients.mean_gradients());
      for (int i = 0; i < cell_gradients.n_nodes(); ++i)
        at(cell_gradients.node(i)).internal += force.col(i);
    });
  }

  /// Gradient of the nodes' displacement.
  [[nodiscard]] Tensor<dim> gradient_of(const CellGradients<Space>& cell,
                                        const typename Stencil::Gradients& gradients) {
    Tensor<dim> gradient = Tensor<dim>::Zero();
    for (int i = 0; i < cell.n_nodes(); ++i)
      gradient += at(cell.node(i)).displacement * gradients.col(i).transpose();
    return gradient;
  }

  void move_point(int cell, std::size_t p) {
    const Stencil stencil = body_.space.stencil(cell, body_.points, p);
    Vector<dim> move = Vector<dim>::Zero();
    for (int i = 0; i < stencil.size(); ++i)
      move += stencil.value(i) * at(stencil.node(i)).displacement;
    for (std::size_t d = 0; d < dim; ++d)
      body_.points.position[d][p] += move[static_cast<int>(d)];
  }
};

} // namespace settle::mpm
