/// \file
/// Weighted norms of a leg: how far values are from their reference, relative to the reference.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::compare {

/// Both sides of a leg at the n material points they have in common, c components at each, SI units of the quantity.
/// Where there is nothing to compare, `problem` says why in a sentence.
struct LegSamples {
  std::vector<double> value{};     ///< (n, c)
  std::vector<double> reference{}; ///< (n, c)
  std::vector<double> weight{};    ///< (n) current volume for points, 1 for probes and scalars
  std::size_t without_partner = 0; ///< samples of either side left out because the other has no such point
  std::string problem{};

  [[nodiscard]] std::size_t size() const { return weight.size(); }
};

/// `l2`: sqrt(sum w |v|^2 / sum w). `linf`: largest |v|, weights play no part. |v|: Euclidean norm of a point's
/// components; values (n, c), weights (n). NaN where a value or a weight is NaN or there are no values.
double norm_of(const std::vector<double>& values, const std::vector<double>& weights, exchange::Norm norm);

/// A difference and what it is relative to.
struct RelativeNorm {
  double value = 0;      ///< norm of the difference over `scale` [-]
  double scale = 0;      ///< SI units of the quantity
  std::string problem{}; ///< why there is no value; empty where there is one
};

/// The norm of value - reference, relative to `scale`, or to the same norm of the reference where none is given.
/// No points, a NaN on either side, or a reference that is zero everywhere are problems, never a value.
RelativeNorm relative_norm(const LegSamples& samples, exchange::Norm norm, std::optional<double> scale = {});

} // namespace settle::compare
