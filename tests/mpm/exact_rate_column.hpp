/// \file
/// The staged column of law `rate` in closed form, written for these tests only: nothing is taken from the solver or
/// from compare.
#pragma once

#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::mpm::test {

/// What a column is made of.
struct ColumnData {
  double height = 5.0; ///< H [m]
  int layers = 5;
  exchange::Convention convention = exchange::Convention::refill;
  double modulus = 480e3;            ///< constrained modulus M [Pa]
  double unit_weight = 1720. * 9.81; ///< as placed [N/m3]
};

/// Confined compression of the law d(sigma) = M d(x)/x: stretch exp(-W/M) under the overburden W. Equilibrium is exact
/// on mass, so the height of what lies between two overburdens is the integral of the stretch over W / unit weight.
class ExactRateColumn {
public:
  explicit ExactRateColumn(const ColumnData& data);

  /// Settlement since placement [m] of the point of layer k at relative height xi, after `stage` (both from 1).
  [[nodiscard]] double settlement(int layer, double xi, int stage) const;
  /// Vertical stress of that point, tension positive [Pa].
  [[nodiscard]] double vertical_stress(int layer, double xi, int stage) const;
  /// Weight per area of everything after a stage [Pa]; 0: nothing.
  [[nodiscard]] double weight(int stage) const { return weight_[static_cast<std::size_t>(stage)]; }
  /// Height of the column after a stage [m].
  [[nodiscard]] double surface(int stage) const { return height_under(weight(stage)); }

private:
  struct Placement {
    double base, thickness; ///< [m]
  };
  [[nodiscard]] double height_under(double overburden) const;
  [[nodiscard]] double weight_below(int layer, double xi) const;
  [[nodiscard]] Placement place(int layer) const;
  [[nodiscard]] double weight_after(int layer) const;

  ColumnData data_;
  std::vector<double> weight_;        ///< by stage, from 0
  std::vector<Placement> placements_; ///< by layer, from 1; entry 0 unused
};

} // namespace settle::mpm::test
