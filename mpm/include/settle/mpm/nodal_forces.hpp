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

} // namespace settle::mpm
