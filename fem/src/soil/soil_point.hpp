/// \file
/// What a soil law takes and gives: pure functions of a point's state and a strain increment, always in space, tension
/// positive.
#pragma once

#include <deal.II/base/symmetric_tensor.h>

namespace settle::fem {

/// I of second order.
inline const dealii::SymmetricTensor<2, 3> unit_tensor = dealii::unit_symmetric_tensor<3>();

/// What a point remembers besides its stress.
struct StateVariables {
  double plastic_strain = 0.0; ///< sum of sqrt(2/3 de:de) over increments, e the deviatoric plastic strain [-]
  double preconsolidation_pressure = 0.0; ///< p_c of cam-clay [Pa]; 0 of other laws
};

struct SoilPoint {
  dealii::SymmetricTensor<2, 3> stress; ///< Cauchy [Pa]
  StateVariables variables;
};

/// What a law answers to a strain increment.
struct SoilResponse {
  SoilPoint point;                       ///< at the end of the increment
  dealii::SymmetricTensor<4, 3> tangent; ///< d stress / d strain increment [Pa]; no major symmetry in general
};

} // namespace settle::fem
