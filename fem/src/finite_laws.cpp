#include "finite_laws.hpp"

#include <cmath>

#include "left_stretch.hpp"

namespace settle::fem {
namespace {

using Symmetric = dealii::SymmetricTensor<2, 3>;

/// The moduli of a linear map of symmetric tensors, column by column.
template <class Map>
dealii::SymmetricTensor<4, 3> moduli_of(const Map& map) {
  dealii::SymmetricTensor<4, 3> moduli;
  for (unsigned k = 0; k < 3; ++k)
    for (unsigned l = k; l < 3; ++l) {
      Symmetric unit;
      unit[k][l] = k == l ? 1.0 : 0.5; // the other half stands at [l][k]
      const Symmetric column = map(unit);
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = i; j < 3; ++j)
          moduli[i][j][k][l] = column[i][j];
    }
  return moduli;
}

/// w x - x w
Symmetric spun(const dealii::Tensor<2, 3>& w, const Symmetric& x) {
  return 2.0 * symmetrize(w * dealii::Tensor<2, 3>(x));
}

std::optional<PointResponse> rate(const Elasticity& constants, const PointMotion& motion, double volume_ratio,
                                  Wanted wanted) {
  const dealii::Tensor<2, 3> start = dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>()) + motion.before;
  const LeftStretch stretch(motion.increment * invert(start));
  if (!stretch.regular()) return {};
  const dealii::Tensor<2, 3> rotation = stretch.rotation();
  const Symmetric rotated = symmetrize(rotation * dealii::Tensor<2, 3>(motion.stress) * transpose(rotation));
  const Symmetric cauchy = rotated + hooke(constants, stretch.logarithm());
  PointResponse response{volume_ratio, volume_ratio * cauchy, {}};
  if (wanted == Wanted::stress) return response;
  const LogarithmRate logarithm_rate(stretch);
  response.moduli = moduli_of([&](const Symmetric& d) {
    return volume_ratio *
           (trace(d) * cauchy + spun(stretch.rotation_rate(d), rotated) + hooke(constants, logarithm_rate(d)));
  });
  return response;
}

std::optional<PointResponse> hencky(const Elasticity& constants, const dealii::Tensor<2, 3>& gradient,
                                    double volume_ratio, Wanted wanted) {
  const LeftStretch stretch(gradient);
  if (!stretch.regular()) return {};
  PointResponse response{volume_ratio, hooke(constants, stretch.logarithm()), {}};
  if (wanted == Wanted::stress) return response;
  const LogarithmRate logarithm_rate(stretch);
  response.moduli = moduli_of([&](const Symmetric& d) { return hooke(constants, logarithm_rate(d)); });
  return response;
}

PointResponse neo_hookean(const Elasticity& constants, const dealii::Tensor<2, 3>& gradient, double volume_ratio,
                          Wanted wanted) {
  const Symmetric identity = dealii::unit_symmetric_tensor<3>();
  const Symmetric strain = left_strain(gradient);
  const dealii::Tensor<2, 3> b(identity + strain);
  const double lame = constants.lame(), shear = constants.shear_modulus();
  PointResponse response{volume_ratio, lame * std::log1p(volume_change(gradient)) * identity + shear * strain, {}};
  if (wanted == Wanted::stress) return response;
  response.moduli = moduli_of([&](const Symmetric& d) {
    return lame * trace(d) * identity + 2.0 * shear * symmetrize(dealii::Tensor<2, 3>(d) * b);
  });
  return response;
}

} // namespace

std::optional<PointResponse> respond(exchange::Law law, const Elasticity& constants, const PointMotion& motion,
                                     Wanted wanted) {
  const double volume_ratio = 1.0 + volume_change(motion.after);
  if (!(volume_ratio > 0.0)) return {};
  switch (law) {
  case exchange::Law::rate:
    return rate(constants, motion, volume_ratio, wanted);
  case exchange::Law::hencky:
    return hencky(constants, motion.after, volume_ratio, wanted);
  case exchange::Law::neo_hookean:
    return neo_hookean(constants, motion.after, volume_ratio, wanted);
  default:
    break;
  }
  return {};
}

} // namespace settle::fem
