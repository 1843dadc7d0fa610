#include "soil_law.hpp"

namespace settle::fem {
namespace {

using Symmetric = dealii::SymmetricTensor<2, 3>;

std::optional<SoilResponse> respond_as(const Elasticity& law, const SoilPoint& start, const Symmetric& strain) {
  return SoilResponse{{start.stress + hooke(law, strain), start.variables}, stiffness<3>(law)};
}

template <class PrincipalLaw>
std::optional<SoilResponse> respond_as(const PrincipalLaw& law, const SoilPoint& start, const Symmetric& strain) {
  return return_spectrally(law.elasticity(), start, strain, std::cref(law));
}

std::optional<SoilResponse> respond_as(const CamClay& law, const SoilPoint& start, const Symmetric& strain) {
  return respond(law, start, strain);
}

std::optional<SoilResponse> respond_as(const StressDependent& law, const SoilPoint& start, const Symmetric& strain) {
  return respond(law, start, strain);
}

dealii::SymmetricTensor<4, 3> isotropic(double bulk, double shear) {
  return bulk * dealii::outer_product(dealii::unit_symmetric_tensor<3>(), dealii::unit_symmetric_tensor<3>()) +
         2.0 * shear * dealii::deviator_tensor<3>();
}

} // namespace

std::optional<SoilResponse> respond(const SoilLaw& law, const SoilPoint& start, const Symmetric& strain_increment) {
  return std::visit([&](const auto& kind) { return respond_as(kind, start, strain_increment); }, law);
}

dealii::SymmetricTensor<4, 3> elastic_stiffness(const SoilLaw& law, const SoilPoint& point) {
  if (const auto* elastic = std::get_if<Elasticity>(&law)) return stiffness<3>(*elastic);
  if (const auto* planes = std::get_if<YieldPlanes>(&law)) return stiffness<3>(planes->elasticity());
  if (const auto* cone = std::get_if<Cone>(&law)) return stiffness<3>(cone->elasticity());
  if (const auto* clay = std::get_if<CamClay>(&law)) {
    const double pressure = clay->attraction - trace(point.stress) / 3.0;
    return isotropic((1.0 + clay->void_ratio) / clay->swelling_index * pressure, clay->shear_modulus);
  }
  return respond(std::get<StressDependent>(law), point, {})->tangent;
}

bool yields(const SoilLaw& law) {
  return !std::holds_alternative<Elasticity>(law) && !std::holds_alternative<StressDependent>(law);
}

} // namespace settle::fem
