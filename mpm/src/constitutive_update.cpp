#include "constitutive_update.hpp"

#include <cmath>
#include <type_traits>

#include "layered_update.hpp"
#include "point_update.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

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
  constexpr int dim = Space::dim;
  if (!body.materials.empty()) return layered_response(body, range, start.points_volume, kinematics);
  if (body.law == exchange::Law::rate) return rate_response(body, start.average.tensor, kinematics);
  Response<dim> response = no_response<dim>();
  with_hyperelastic_law<dim>(body.law, [&]<class Law>(std::type_identity<Law>) {
    for (std::size_t p = range.first; p < range.last; ++p)
      add_hyperelastic_point<Law>(body.lame, body.points, p, body.points.volume[p] / start.points_volume, kinematics,
                                  response);
  });
  return response;
}

template <class Space>
void deform_points(Body<Space>& body, PointRange range, const IncrementalKinematics<Space::dim>& kinematics,
                   StrainMeasure measure) {
  for (std::size_t p = range.first; p < range.last; ++p)
    body.points.volume[p] *= kinematics.volume_ratio;
  if constexpr (Space::has_domains) deform_domains(body.points, range, kinematics);
  if (!body.materials.empty()) return deform_layered_points(body, range, kinematics, measure);
  if (body.law == exchange::Law::rate) return deform_rate_points(body, range, kinematics, measure);
  with_hyperelastic_law<Space::dim>(body.law, [&]<class Law>(std::type_identity<Law>) {
    for (std::size_t p = range.first; p < range.last; ++p)
      deform_hyperelastic_point<Law>(body.lame, body.points, p, kinematics);
  });
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template Response<Space::dim> respond(const Body<Space>&, PointRange, const AverageStress<Space::dim>&,              \
                                        const IncrementalKinematics<Space::dim>&);                                     \
  template void deform_points(Body<Space>&, PointRange, const IncrementalKinematics<Space::dim>&, StrainMeasure);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
