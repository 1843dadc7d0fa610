/// \file
/// Which of many things in the plane are near a point.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "settle/exchange/plane_geometry.hpp"

namespace settle::compare {

/// A lattice of bins over a rectangle; what is beyond it counts to the bins at its edge.
class PlaneBins {
public:
  /// Things with these boxes, known by their numbers: about one a bin. Coordinates are finite [m].
  explicit PlaneBins(const std::vector<exchange::PlaneBox>& boxes);

  /// The numbers of all things in bins that this box touches: each once, in ascending order. Those that touch the box
  /// itself are among them.
  [[nodiscard]] std::vector<std::size_t> near(const exchange::PlaneBox& box) const;
  /// Edge of a bin, the longer one [m].
  [[nodiscard]] double edge() const;
  /// Around everything [m].
  [[nodiscard]] const exchange::PlaneBox& extent() const { return extent_; }

private:
  [[nodiscard]] std::size_t bin_along(std::size_t axis, double at) const;
  template <class Visit>
  void visit(const exchange::PlaneBox& box, const Visit& visit) const;

  exchange::PlaneBox extent_{};
  std::array<std::size_t, 2> count_{1, 1};
  std::vector<std::vector<std::size_t>> bins_;
};

} // namespace settle::compare
