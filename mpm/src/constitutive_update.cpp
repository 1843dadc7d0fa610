#include "constitutive_update.hpp"

#include <cmath>
#include <type_traits>

#include "settle/mpm/hyperelasticity.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

/// Calls `action` with the type of the body's hyperelastic law; the law `rate` is none and does not come here.
template <class Space, class Action>
auto with_hyperelastic_law(const Body<Space>& body, Action&& action) {
  if (body.law == exchange::Law::hencky) return action(std::type_identity<Hencky<Space::dim>>());
  return action(std::type_identity<NeoHookean<Space::dim>>());
}

/// Variation of b = F F^T by a displacement whose gradient is e_direction (x) e_axis.
template <int dim>
Tensor<dim> variation_of_b(const Tensor<dim>& b, int direction, int axis) {
  Tensor<dim> half = Tensor<dim>::Zero();
  half.row(direction) = b.row(axis);
  return half + half.transpose();
}

/// Calls `variation(direction, axis)` for every component of the gradient.
template <int dim, class Variation>
void differentiate(Response<dim>& response, Variation&& variation) {
  for (int direction = 0; direction < dim; ++direction)
    for (int axis = 0; axis < dim; ++axis)
      variation(response.by_gradient[static_cast<std::size_t>(direction)][static_cast<std::size_t>(axis)], direction,
                axis);
}

/// Law `rate`: sigma = R sigma_0 R^T + D : e, e the logarithmic strain of the increment, R its rotation for the Jaumann
/// rate, else the identity. It is linear in sigma_0, so the average of the points' stresses is the stress of their
/// average.
template <class Space, int dim = Space::dim>
Response<dim> rate_response(const Body<Space>& body, const Tensor<dim>& start,
                            const IncrementalKinematics<dim>& kinematics) {
  const Tensor<dim> rotation = body.jaumann ? kinematics.rotation() : Tensor<dim>::Identity();
  const Tensor<dim> b = kinematics.deformation * kinematics.deformation.transpose();
  const Hencky<dim> increment(body.lame, b);
  Response<dim> response;
  response.stress = rotation * start * rotation.transpose() + increment.kirchhoff().tensor;
  differentiate(response, [&](Tensor<dim>& variation, int direction, int axis) {
    variation = increment.variation(variation_of_b<dim>(b, direction, axis)).tensor;
    if (!body.jaumann) return;
    const Vector<dim> at_start = kinematics.deformation.row(axis).transpose(); // F^T e_axis
    const Tensor<dim> d_rotation = 0.5 * kinematics.half_rotation() * kinematics.spin_variation(at_start, direction) *
                                   (Tensor<dim>::Identity() + rotation);
    const Tensor<dim> turned = d_rotation * start * rotation.transpose();
    variation += turned + turned.transpose();
  });
  return response;
}

/// sigma = tau(b) / J point by point; d_sigma = d_tau / J - div(d_u) sigma.
template <class Law, class Space, int dim = Space::dim>
Response<dim> hyperelastic_response(const Body<Space>& body, PointRange range, double points_volume,
                                    const IncrementalKinematics<dim>& kinematics) {
  Response<dim> response;
  response.stress.setZero();
  differentiate(response, [](Tensor<dim>& variation, int, int) { variation.setZero(); });
  for (std::size_t p = range.first; p < range.last; ++p) {
    const double weight = body.points.volume[p] / points_volume;
    const Tensor<dim> deformation = kinematics.deformation * body.points.deformation_of(p);
    const Tensor<dim> b = deformation * deformation.transpose();
    const double jacobian = deformation.determinant();
    const Law law(body.lame, b);
    const Tensor<dim> sigma = law.kirchhoff().tensor / jacobian;
    response.stress += weight * sigma;
    differentiate(response, [&](Tensor<dim>& variation, int direction, int axis) {
      variation += weight * law.variation(variation_of_b<dim>(b, direction, axis)).tensor / jacobian;
      if (direction == axis) variation -= weight * sigma;
    });
  }
  return response;
}

template <class Space>
void deform_rate_points(Body<Space>& body, PointRange range, const IncrementalKinematics<Space::dim>& kinematics,
                        StrainMeasure measure) {
  constexpr int dim = Space::dim;
  const auto increment =
      measure == StrainMeasure::midpoint
          ? stress_increment<dim>(body.lame, kinematics.strain)
          : Hencky<dim>(body.lame, kinematics.deformation * kinematics.deformation.transpose()).kirchhoff();
  for (std::size_t p = range.first; p < range.last; ++p) {
    auto stress = stress_of(body.points, p);
    if (body.jaumann) {
      const Tensor<dim> rotation = kinematics.rotation();
      stress.tensor = (rotation * stress.tensor * rotation.transpose()).eval();
    }
    stress.tensor += increment.tensor;
    stress.out_of_plane += increment.out_of_plane;
    set_stress(body.points, p, stress);
  }
}

template <class Law, class Space>
void deform_hyperelastic_points(Body<Space>& body, PointRange range,
                                const IncrementalKinematics<Space::dim>& kinematics) {
  constexpr int dim = Space::dim;
  const Tensor<dim> increment = kinematics.deformation;
  for (std::size_t p = range.first; p < range.last; ++p) {
    const Tensor<dim> deformation = increment * body.points.deformation_of(p);
    body.points.set_deformation(p, deformation);
    Stress<dim> stress = Law(body.lame, deformation * deformation.transpose()).kirchhoff();
    stress.tensor /= deformation.determinant();
    stress.out_of_plane /= deformation.determinant();
    set_stress(body.points, p, stress);
  }
}

/// A domain's sides take the lengths that the increment gives them, both made longer or shorter alike so that its
/// volume changes as the point's: a rotation turns no domain, and does not shrink it either.
template <int dim>
void deform_domains(Points<dim>& points, PointRange range, const IncrementalKinematics<dim>& kinematics) {
  const Vector<dim> lengths = kinematics.deformation.colwise().norm().transpose();
  const Vector<dim> ratio = std::pow(kinematics.volume_ratio / lengths.prod(), 1.0 / dim) * lengths;
  for (std::size_t p = range.first; p < range.last; ++p)
    for (int c = 0; c < dim; ++c)
      points.half_length[static_cast<std::size_t>(c)][p] *= ratio[c];
}

} // namespace

template <class Space>
Response<Space::dim> respond(const Body<Space>& body, PointRange range, const AverageStress<Space::dim>& start,
                             const IncrementalKinematics<Space::dim>& kinematics) {
  if (body.law == exchange::Law::rate) return rate_response(body, start.average.tensor, kinematics);
  return with_hyperelastic_law(body, [&]<class Law>(std::type_identity<Law>) {
    return hyperelastic_response<Law>(body, range, start.points_volume, kinematics);
  });
}

template <class Space>
void deform_points(Body<Space>& body, PointRange range, const IncrementalKinematics<Space::dim>& kinematics,
                   StrainMeasure measure) {
  for (std::size_t p = range.first; p < range.last; ++p)
    body.points.volume[p] *= kinematics.volume_ratio;
  if constexpr (Space::has_domains) deform_domains(body.points, range, kinematics);
  if (body.law == exchange::Law::rate) return deform_rate_points(body, range, kinematics, measure);
  with_hyperelastic_law(
      body, [&]<class Law>(std::type_identity<Law>) { deform_hyperelastic_points<Law>(body, range, kinematics); });
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template Response<Space::dim> respond(const Body<Space>&, PointRange, const AverageStress<Space::dim>&,              \
                                        const IncrementalKinematics<Space::dim>&);                                     \
  template void deform_points(Body<Space>&, PointRange, const IncrementalKinematics<Space::dim>&, StrainMeasure);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
