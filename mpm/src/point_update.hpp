/// \file
/// What an increment's deformation does to a single hyperelastic point, and how responses are differentiated.
#pragma once

#include "constitutive_update.hpp"
#include "settle/mpm/hyperelasticity.hpp"

namespace settle::mpm {

/// Variation of b = F F^T by a displacement whose gradient is e_direction (x) e_axis.
template <int dim>
Tensor<dim> variation_of_b(const Tensor<dim>& b, int direction, int axis) {
  Tensor<dim> half = Tensor<dim>::Zero();
  half.row(direction) = b.row(axis);
  return half + half.transpose();
}

/// Calls `variation(derivative, direction, axis)` for every component of the gradient.
template <int dim, class Variation>
void differentiate(Response<dim>& response, Variation&& variation) {
  for (int direction = 0; direction < dim; ++direction)
    for (int axis = 0; axis < dim; ++axis)
      variation(response.by_gradient[static_cast<std::size_t>(direction)][static_cast<std::size_t>(axis)], direction,
                axis);
}

/// A response to add to.
template <int dim>
Response<dim> no_response() {
  Response<dim> response;
  response.stress.setZero();
  differentiate(response, [](Tensor<dim>& derivative, int, int) { derivative.setZero(); });
  return response;
}

/// Calls `action` with the type of a hyperelastic law.
template <int dim, class Action>
auto with_hyperelastic_law(exchange::Law law, Action&& action) {
  if (law == exchange::Law::hencky) return action(std::type_identity<Hencky<dim>>());
  return action(std::type_identity<NeoHookean<dim>>());
}

/// Adds `weight` times the response of point p: sigma = tau(b) / J, d_sigma = d_tau / J - div(d_u) sigma.
template <class Law, int dim>
void add_hyperelastic_point(const Lame& lame, const Points<dim>& points, std::size_t p, double weight,
                            const IncrementalKinematics<dim>& kinematics, Response<dim>& response) {
  const Tensor<dim> deformation = kinematics.deformation * points.deformation_of(p);
  const Tensor<dim> b = deformation * deformation.transpose();
  const double jacobian = deformation.determinant();
  const Law law(lame, b);
  const Tensor<dim> sigma = law.kirchhoff().tensor / jacobian;
  response.stress += weight * sigma;
  differentiate(response, [&](Tensor<dim>& derivative, int direction, int axis) {
    derivative += weight * law.variation(variation_of_b<dim>(b, direction, axis)).tensor / jacobian;
    if (direction == axis) derivative -= weight * sigma;
  });
}

template <class Law, int dim>
void deform_hyperelastic_point(const Lame& lame, Points<dim>& points, std::size_t p,
                               const IncrementalKinematics<dim>& kinematics) {
  const Tensor<dim> deformation = kinematics.deformation * points.deformation_of(p);
  points.set_deformation(p, deformation);
  Stress<dim> stress = Law(lame, deformation * deformation.transpose()).kirchhoff();
  stress.tensor /= deformation.determinant();
  stress.out_of_plane /= deformation.determinant();
  set_stress(points, p, stress);
}

} // namespace settle::mpm
