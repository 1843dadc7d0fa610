/// \file
/// What an increment's deformation of some points does to their stress: the response a Newton iteration needs, and the
/// update of the points once the increment is accepted.
#pragma once

#include "incremental_kinematics.hpp"
#include "settle/mpm/body.hpp"

namespace settle::mpm {

/// Average Cauchy stress of some points at the end of an increment and its derivative with respect to a gradient h of a
/// displacement on top of it, taken where the points are then: d(stress) = sum_ba h_ba by_gradient[b][a] [Pa]. For the
/// degree of freedom of node j in direction b, h_ba is the a-th component of the node's current gradient.
template <int dim>
struct Response {
  Tensor<dim> stress;
  PerAxis<PerAxis<Tensor<dim>, dim>, dim> by_gradient;
};

/// For points that deform alike, `start` their average stress at the start of the increment. The average keeps their
/// volumes as weights: all change by the same ratio.
template <class Space>
Response<Space::dim> respond(const Body<Space>& body, PointRange range, const AverageStress<Space::dim>& start,
                             const IncrementalKinematics<Space::dim>& kinematics);

/// How the law `rate` measures the strain of an increment.
enum class StrainMeasure {
  midpoint,   ///< sym(G (I + G/2)^-1): right to third order, enough for the small steps of the explicit scheme
  logarithmic ///< 1/2 ln(F F^T): exact where the principal axes do not turn, for quasi-static increments of any size
};

/// Volume, stress and, where tracked, deformation gradient of points that deform alike at the end of the increment.
template <class Space>
void deform_points(Body<Space>& body, PointRange range, const IncrementalKinematics<Space::dim>& kinematics,
                   StrainMeasure measure);

} // namespace settle::mpm
