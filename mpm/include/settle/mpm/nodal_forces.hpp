/// \file
/// Forces between points and nodes that both schemes need.
#pragma once

#include "settle/mpm/body.hpp"

namespace settle::mpm {

/// Weight of the points at the nodes, gravity factors applied; (dim * nodes), direction fastest [N/m] in 2-D.
template <class Space>
Eigen::VectorXd external_forces(const Body<Space>& body, const Gravity& gravity);

/// What the base carries, positive upward: internal minus external force over the vertically fixed nodes [N/m] in 2-D.
template <class Space>
double base_reaction(const Body<Space>& body, const Eigen::VectorXd& internal, const Eigen::VectorXd& external) {
  constexpr int dim = Space::dim;
  double reaction = 0;
  for (std::size_t node = 0; node < body.fixed.size(); ++node) {
    const auto vertical = static_cast<Eigen::Index>(dim * node + dim - 1);
    if (body.fixed[node][dim - 1]) reaction += internal[vertical] - external[vertical];
  }
  return reaction;
}

/// What each support does to the body, internal less external force where a node is held, zero elsewhere;
/// (dim * nodes) [N/m] in 2-D.
template <class Space>
Eigen::VectorXd support_forces(const Body<Space>& body, const Eigen::VectorXd& internal,
                               const Eigen::VectorXd& external) {
  constexpr std::size_t dim = Space::dim;
  Eigen::VectorXd forces = internal - external;
  for (std::size_t dof = 0; dof < dim * body.fixed.size(); ++dof)
    if (!body.fixed[dof / dim][dof % dim]) forces[static_cast<Eigen::Index>(dof)] = 0.0;
  return forces;
}

} // namespace settle::mpm
