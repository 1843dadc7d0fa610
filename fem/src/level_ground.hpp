/// \file
/// The stress that level ground starts with where a case gives its ratio of horizontal to vertical stress.
#pragma once

#include <optional>
#include <vector>

#include <deal.II/base/symmetric_tensor.h>

#include "settle/exchange/case.hpp"

namespace settle::fem {

/// Layers of ground whose stage gives a `k0`; all others have no part in it.
class LevelGround {
public:
  explicit LevelGround(const exchange::Case& study);

  /// At a height of a layer once the first stages are placed, Cauchy [Pa]: vertically the weight of the ground above,
  /// horizontally k0 of that. Nothing where the layer's stage gives no k0.
  template <int dim>
  [[nodiscard]] std::optional<dealii::SymmetricTensor<2, 3>> stress(int layer, double height, int stages) const;

private:
  struct Stratum {
    int layer;
    double bottom, top; ///< [m]
    double unit_weight; ///< [N/m3]
    std::optional<double> k0;
  };
  [[nodiscard]] double overburden(double height, int stages) const;

  std::vector<Stratum> strata_; ///< by the stages that place them
};

} // namespace settle::fem
