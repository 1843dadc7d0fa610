/// \file
/// Laws that return a trial stress along its principal axes: from three numbers to tensors, with the consistent
/// tangent.
#pragma once

#include <functional>
#include <optional>

#include "../elasticity.hpp"
#include "soil_point.hpp"

namespace settle::fem {

/// Principal stresses [Pa], tension positive.
using Principal = dealii::Tensor<1, 3>;

struct PrincipalReturn {
  Principal stress;                ///< [Pa]
  dealii::Tensor<2, 3> derivative; ///< [i][j]: of stress i by trial stress j
};

/// From trial stresses in descending order to those returned, in the same order; nothing where that fails. Where the
/// trial does not yield it is given back as it is, with the identity as derivative.
using PrincipalMap = std::function<std::optional<PrincipalReturn>(const Principal& trial)>;

/// D in principal axes: lambda 1 (1 . x) + 2 mu x.
Principal hooke(const Elasticity& law, const Principal& strain);

/// Isotropic linear elasticity, then the return of sigma + D : d(eps) along its principal axes n_i. The tangent is
/// that of the isotropic tensor function sum s_i(t) n_i n_i (de Souza Neto, Peric & Owen, Computational Methods for
/// Plasticity, 2008, appendix A): d s_i/d t_j between axes and (s_i - s_j)/(t_i - t_j) for their turning, its limit
/// where two trial stresses coincide.
std::optional<SoilResponse> return_spectrally(const Elasticity& law, const SoilPoint& start,
                                              const dealii::SymmetricTensor<2, 3>& strain_increment,
                                              const PrincipalMap& map);

} // namespace settle::fem
