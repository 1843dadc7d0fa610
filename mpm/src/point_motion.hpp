/// \file
/// Points at the end of an increment.
#pragma once

#include "settle/mpm/body.hpp"

namespace settle::mpm {

/// Moves the points of a cell with the nodes, by their displacement in the increment (dim * nodes) [m], and deforms
/// them with their patch. The points are not sorted.
template <class Space>
void move_points(Body<Space>& body, int cell, const Eigen::VectorXd& displacement);

} // namespace settle::mpm
