#include "layered_update.hpp"

#include <type_traits>

#include "point_update.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

/// Back from six numbers of a stress: in plane strain its shears across the plane are zero.
template <int dim>
Stress<dim> stress_of_six(const soil::Voigt& six) {
  return stress_of_components<dim>([&](std::size_t c) { return six[static_cast<Eigen::Index>(c)]; });
}

template <int dim>
soil::State state_of(const Points<dim>& points, std::size_t p) {
  return {.plastic_strain = points.yields ? points.plastic_strain[p] : 0.0,
          .preconsolidation_pressure = points.hardens ? points.preconsolidation_pressure[p] : 0.0};
}

template <int dim>
void set_state(Points<dim>& points, std::size_t p, const soil::State& state) {
  if (points.yields) points.plastic_strain[p] = state.plastic_strain;
  if (points.hardens) points.preconsolidation_pressure[p] = state.preconsolidation_pressure;
}

template <int dim>
soil::Voigt turned_stress(const Points<dim>& points, std::size_t p, const Tensor<dim>& rotation) {
  Stress<dim> stress = stress_of(points, p);
  stress.tensor = (rotation * stress.tensor * rotation.transpose()).eval();
  return soil::six_of(stress);
}

template <class Space>
const Material& material_at(const Body<Space>& body, std::size_t p) {
  return body.material_of(body.points.layer[p]);
}

/// What soils take from an increment: its strain and rotation.
template <int dim>
struct SoilStep {
  soil::Voigt strain;
  Tensor<dim> rotation;

  SoilStep(bool jaumann, const IncrementalKinematics<dim>& kinematics, const Tensor<dim>& strain_tensor)
      : strain(soil::six_of<dim>({strain_tensor}, 2.0)),
        rotation(jaumann ? kinematics.rotation() : Tensor<dim>::Identity()) {}
};

/// The variation of the rotated stress by that of the rotation, as the strain that has the same effect, is added to
/// that of the strain: see soil::Update::shear_modulus.
template <class Space, int dim = Space::dim>
void add_soil_point(const Body<Space>& body, std::size_t p, double weight, const SoilStep<dim>& step,
                    const IncrementalKinematics<dim>& kinematics, const LogarithmicStrain<dim>& logarithm,
                    const Tensor<dim>& b, Response<dim>& response) {
  const soil::Voigt start = turned_stress(body.points, p, step.rotation);
  const soil::Update update =
      soil::update(material_at(body, p).soil, start, state_of(body.points, p), step.strain, soil::Wanted::tangent);
  response.stress += weight * stress_of_six<dim>(update.stress).tensor;
  const Tensor<dim> stress = stress_of_six<dim>(start).tensor;
  const Tensor<dim> before = step.rotation.transpose() * stress * step.rotation;
  differentiate(response, [&](Tensor<dim>& derivative, int direction, int axis) {
    Tensor<dim> strain = logarithm.variation(variation_of_b<dim>(b, direction, axis));
    if (body.jaumann) {
      const Vector<dim> at_start = kinematics.deformation.row(axis).transpose(); // F^T e_axis
      const Tensor<dim> d_rotation = 0.5 * kinematics.half_rotation() * kinematics.spin_variation(at_start, direction) *
                                     (Tensor<dim>::Identity() + step.rotation);
      const Tensor<dim> turned = d_rotation * before * step.rotation.transpose();
      strain += (turned + turned.transpose()) / (2.0 * update.shear_modulus);
    }
    derivative += weight * stress_of_six<dim>(update.tangent * soil::six_of<dim>({strain}, 2.0)).tensor;
  });
}

} // namespace

template <class Space>
Response<Space::dim> layered_response(const Body<Space>& body, PointRange range, double points_volume,
                                      const IncrementalKinematics<Space::dim>& kinematics) {
  constexpr int dim = Space::dim;
  const Tensor<dim> b = kinematics.deformation * kinematics.deformation.transpose();
  const LogarithmicStrain<dim> logarithm(b);
  const SoilStep<dim> step(body.jaumann, kinematics, logarithm.strain());
  Response<dim> response = no_response<dim>();
  for (std::size_t p = range.first; p < range.last; ++p) {
    const double weight = body.points.volume[p] / points_volume;
    const Material& material = material_at(body, p);
    if (material.is_hyperelastic())
      with_hyperelastic_law<dim>(material.law, [&]<class Law>(std::type_identity<Law>) {
        add_hyperelastic_point<Law>(material.lame, body.points, p, weight, kinematics, response);
      });
    else
      add_soil_point(body, p, weight, step, kinematics, logarithm, b, response);
  }
  return response;
}

template <class Space>
void deform_layered_points(Body<Space>& body, PointRange range, const IncrementalKinematics<Space::dim>& kinematics,
                           StrainMeasure measure) {
  constexpr int dim = Space::dim;
  const Tensor<dim> strain =
      measure == StrainMeasure::midpoint
          ? kinematics.strain
          : LogarithmicStrain<dim>(kinematics.deformation * kinematics.deformation.transpose()).strain();
  const SoilStep<dim> step(body.jaumann, kinematics, strain);
  for (std::size_t p = range.first; p < range.last; ++p) {
    const Material& material = material_at(body, p);
    if (material.is_hyperelastic()) {
      with_hyperelastic_law<dim>(material.law, [&]<class Law>(std::type_identity<Law>) {
        deform_hyperelastic_point<Law>(material.lame, body.points, p, kinematics);
      });
      continue;
    }
    const soil::Update update = soil::update(material.soil, turned_stress(body.points, p, step.rotation),
                                             state_of(body.points, p), step.strain, soil::Wanted::stress);
    set_stress(body.points, p, stress_of_six<dim>(update.stress));
    set_state(body.points, p, update.state);
  }
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template Response<Space::dim> layered_response(const Body<Space>&, PointRange, double,                               \
                                                 const IncrementalKinematics<Space::dim>&);                            \
  template void deform_layered_points(Body<Space>&, PointRange, const IncrementalKinematics<Space::dim>&,              \
                                      StrainMeasure);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
