/// \file
/// What one cell adds to the internal forces at the end of an increment, and to their derivative.
#pragma once

#include <type_traits>

#include "cell_gradients.hpp"
#include "incremental_kinematics.hpp"

namespace settle::mpm {

/// A square matrix, on the stack where it is small enough.
template <int size>
using SquareMatrix = std::conditional_t<size * size * sizeof(double) <= EIGEN_STACK_ALLOCATION_LIMIT,
                                        Eigen::Matrix<double, size, size>, Eigen::MatrixXd>;

/// Internal forces of one cell at the end of the increment and their derivative; the first dim * n_nodes() entries.
template <class Space>
struct CellContribution {
  static constexpr int max_dofs = Space::dim * Space::max_nodes;
  Eigen::Matrix<double, max_dofs, 1> force = Eigen::Matrix<double, max_dofs, 1>::Zero();
  SquareMatrix<max_dofs> tangent = SquareMatrix<max_dofs>::Zero(max_dofs, max_dofs);
};

/// Deformation of a patch that its points feel in an increment of the nodes' displacement (dim * nodes) [m].
template <class Space>
IncrementalKinematics<Space::dim> kinematics_of(const Body<Space>& body, const CellGradients<Space>& cell,
                                                const Patch<Space>& patch, const Eigen::VectorXd& displacement);

/// Sets `sum` to what the cell contributes at `displacement`; false if a point turns inside out.
template <class Space>
bool contribute(const Body<Space>& body, const CellGradients<Space>& cell, const Eigen::VectorXd& displacement,
                CellContribution<Space>& sum);

} // namespace settle::mpm
