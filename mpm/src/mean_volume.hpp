/// \file
/// Cells that change their volume as a whole: what keeps material that yields at constant volume from locking.
///
/// At every point of a cell the part of the deformation that changes volume is the cell's own, that of its mean
/// gradient, and the mean stress in the plane (3-D: of all directions) acts by it too (B-bar, Hughes 1980; with finite
/// increments as F-bar, de Souza Neto et al. 1996):
///
///     F'_p = (det F / det F_p)^(1/dim) F_p,    f_i = sum_p v_p [dev(sigma_p) g_ip + mean(sigma_p) g_i]
///
/// with F and g_i of the cell. Where gradients are constant in a cell this changes nothing.
#pragma once

#include <cmath>

#include "cell_gradients.hpp"
#include "incremental_kinematics.hpp"

namespace settle::mpm {

/// The gradient of F'_p from those of F_p and F.
template <int dim>
Tensor<dim> with_volume_of(const Tensor<dim>& point, const Tensor<dim>& cell) {
  const Tensor<dim> deformation = Tensor<dim>::Identity() + point;
  const double ratio = (Tensor<dim>::Identity() + cell).determinant() / deformation.determinant();
  return std::pow(ratio, 1.0 / dim) * deformation - Tensor<dim>::Identity();
}

/// Forces per volume: the deviator acts by the point's gradients, the mean by the cell's.
template <class Space>
typename Space::Stencil::Gradients split_traction(const Tensor<Space::dim>& stress,
                                                  const typename Space::Stencil::Gradients& point,
                                                  const typename Space::Stencil::Gradients& cell) {
  constexpr int dim = Space::dim;
  const double mean = stress.trace() / dim;
  return (stress - mean * Tensor<dim>::Identity()) * point + mean * cell;
}

} // namespace settle::mpm
