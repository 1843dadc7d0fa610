/// \file
/// The three laws at finite strain, always in space: plane strain is a motion without third component.
#pragma once

#include <optional>

#include <deal.II/base/symmetric_tensor.h>

#include "elasticity.hpp"
#include "settle/exchange/case.hpp"

namespace settle::fem {

/// How a material point moves in an increment. Gradients are those of displacement since placement, with respect to
/// the position as placed [-].
struct PointMotion {
  dealii::Tensor<2, 3> before;          ///< gradient at the start of the increment
  dealii::Tensor<2, 3> increment;       ///< what the increment adds to it
  dealii::Tensor<2, 3> after;           ///< their sum. Given, because the next increment has to find the same number
                                        ///< at its start, also where round-off is all that is left of a stretch
  dealii::SymmetricTensor<2, 3> stress; ///< Cauchy at the start of the increment [Pa]
};

/// What the law answers.
struct PointResponse {
  double volume_ratio;                     ///< J, since placement
  dealii::SymmetricTensor<2, 3> kirchhoff; ///< tau = J sigma [Pa]
  dealii::SymmetricTensor<4, 3> moduli;    ///< c [Pa]: d tau = w tau - tau w + c : d where F varies by dF F^-1 = d + w,
                                           ///< d symmetric, w skew. No major symmetry for `rate`.
};

/// Nothing where the motion turns the point inside out (J <= 0), or crushes it flat as far as numbers can tell.
///  - `rate`: sigma = r sigma_0 r^T + D : ln v with v r the polar decomposition of the increment's own motion. It
///    integrates the Jaumann rate to second order in the increment, rotates stress exactly with a rigid motion, and
///    adds up logarithmic strain without error where the principal axes stand still.
///  - `hencky`: tau = D : (1/2) ln b.
///  - `neo-hookean`: tau = lambda ln J I + mu (b - I).
/// Moduli are most of the work: they are zero where only the stress is `wanted`.
enum class Wanted { stress, stress_and_moduli };
std::optional<PointResponse> respond(exchange::Law law, const Elasticity& constants, const PointMotion& motion,
                                     Wanted wanted = Wanted::stress_and_moduli);

} // namespace settle::fem
