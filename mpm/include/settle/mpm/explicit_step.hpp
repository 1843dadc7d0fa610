/// \file
/// One explicit time step: the cycle of Aviles & Pinyol (2023), Figure 1, with momentum remapped from the updated
/// points (MUSL: momentum first, stress last). Each phase is a function of its own.
#pragma once

#include <vector>

#include "settle/mpm/body.hpp"

namespace settle::mpm {

/// What a node carries within a step; packed, because a cell's nodes are touched together.
template <int dim>
struct NodeState {
  double mass = 0;                                ///< lumped [kg/m] in 2-D
  Vector<dim> momentum = Vector<dim>::Zero();     ///< [kg m/s per m]
  Vector<dim> external = Vector<dim>::Zero();     ///< force [N/m]
  Vector<dim> internal = Vector<dim>::Zero();     ///< force, sum of sigma grad N V [N/m]
  Vector<dim> acceleration = Vector<dim>::Zero(); ///< [m/s2]
  Vector<dim> remapped = Vector<dim>::Zero();     ///< momentum from the updated points [kg m/s per m]
  Vector<dim> displacement = Vector<dim>::Zero(); ///< in the step, from the remapped momentum [m]
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

/// Stable step [s]: `courant` times the shortest length of the space over the fastest wave, sqrt(M / density). The
/// density is that of the lightest cell, its points' mass over the volume its stress acts on: a cell that is stiff in
/// full but filled in part has a faster wave than the material.
template <class Space>
double stable_time_step(const Body<Space>& body, double courant);

/// Lumps mass, momentum, weight and internal force of all points to the nodes, which are cleared first.
template <class Space>
void scatter_points(const Body<Space>& body, const Gravity& gravity, Nodes<Space::dim>& nodes);

/// Acceleration of every node with mass: (F_unbalanced + F_damping) / m, with local damping
/// F_damping = -damping |F_unbalanced| sign(velocity) by component; zero where a support holds.
template <class Space>
ForceSums update_nodes(const Body<Space>& body, double damping, Nodes<Space::dim>& nodes);

/// Points' velocities from the nodes' accelerations, and their momentum mapped back to the nodes.
template <class Space>
void update_velocity_and_remap(Body<Space>& body, double dt, Nodes<Space::dim>& nodes);

/// Work and energy of a step's motion.
struct StepEnergy {
  double kinetic = 0;       ///< of the nodes: what the points' velocities cancel out in does not move anything [J/m]
  double external_work = 0; ///< of the weight on this step's displacement [J/m]
};

/// Strain, volume, stress and position of every point from the remapped nodal velocities; then the body is sorted and,
/// if it asks for it, point stresses are replaced by their cell's average. Throws PointLost.
template <class Space>
StepEnergy update_stress_and_move(Body<Space>& body, const Gravity& gravity, double dt, Nodes<Space::dim>& nodes);

} // namespace settle::mpm
