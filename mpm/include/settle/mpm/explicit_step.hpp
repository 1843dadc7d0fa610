/// \file
/// One explicit time step: the cycle of Aviles & Pinyol (2023), Figure 1, with momentum remapped from the updated
/// points (MUSL: momentum first, stress last). Each phase is a function of its own.
#pragma once

#include <memory>
#include <vector>

#include "settle/mpm/body.hpp"

namespace settle::mpm {

/// What a node carries within a step.
template <int dim>
struct NodeState {
  double mass = 0;                                ///< lumped [kg/m] in 2-D
  Vector<dim> momentum = Vector<dim>::Zero();     ///< [kg m/s per m]; until `displace`
  Vector<dim> external = Vector<dim>::Zero();     ///< force [N/m]
  Vector<dim> internal = Vector<dim>::Zero();     ///< force, sum of sigma grad N V [N/m]; until `accelerate`
  Vector<dim> acceleration = Vector<dim>::Zero(); ///< [m/s2]; from `accelerate` on
  Vector<dim> displacement = Vector<dim>::Zero(); ///< in the step, from the remapped momentum [m]; from `displace` on
};

/// Nodes by their index in the grid.
template <int dim>
using Nodes = std::vector<NodeState<dim>>;

/// Sums over the step that tell how far the body is from rest.
struct ForceSums {
  double unbalanced = 0;    ///< sum of |F_external - F_internal| over free components [N/m]
  double external = 0;      ///< sum of |F_external| over all components [N/m]
  double base_reaction = 0; ///< positive upward [N/m]
};

/// Work and energy of a step's motion.
struct StepEnergy {
  double kinetic = 0;       ///< of the nodes: what the points' velocities cancel out in does not move anything [J/m]
  double external_work = 0; ///< of the external forces on this step's displacement [J/m]
};

/// Steps of one body. From the first on its points need not be sorted, nor all be where they belong, until `gather`;
/// nothing else may look at them before.
template <class Space>
class ExplicitStep {
public:
  static constexpr int dim = Space::dim;

  /// The body outlives its steps. Results do not depend on the number of threads, bit for bit. `loaded`: points have
  /// forces besides gravity; in space the step then goes point by point.
  explicit ExplicitStep(Body<Space>& body, int threads = 1, bool loaded = false);
  ExplicitStep(ExplicitStep&&) noexcept;
  ~ExplicitStep();

  /// Lumps mass, momentum, weight and internal force of all points to the nodes.
  void scatter(const Gravity& gravity);
  /// Stable step [s], from the sums of `scatter`: `courant` times the shortest length of the space over the fastest
  /// wave, sqrt(M / density). The density is that of the lightest cell, its points' mass over the volume its stress
  /// acts on: a cell that is stiff in full but filled in part has a faster wave than the material.
  [[nodiscard]] double stable_time_step(double courant) const;
  /// Surface of each column of squares, as `column_heights` of the body, from the sums of `scatter` [m].
  [[nodiscard]] std::vector<double> column_heights() const;
  /// Acceleration of every node with mass: (F_unbalanced + F_damping) / m, with local damping
  /// F_damping = -damping |F_unbalanced| sign(velocity) by component; zero where a support holds.
  ForceSums accelerate(double damping);
  /// Displacements of the nodes over `dt`, from the momentum that the points have with velocities that the nodes'
  /// accelerations have changed over `kick` [s]. Of the points' new velocities `move` leaves the share `kept`.
  StepEnergy displace(double kick, double dt, double kept = 1.0);
  /// Velocity, strain, volume, stress and position of every point; then, if the body asks for it, point stresses are
  /// replaced by their cell's average. Throws PointLost.
  void move();
  /// All points where they belong, and sorted.
  void gather();

  [[nodiscard]] NodeState<dim> node(int node) const;
  /// All nodes, as they are now; until the next call.
  [[nodiscard]] const Nodes<dim>& nodes();
  /// Makes `move` follow a displacement that is given.
  void set_displacement(int node, const Vector<dim>& displacement);

private:
  class Phases;
  std::unique_ptr<Phases> phases_;
};

} // namespace settle::mpm
