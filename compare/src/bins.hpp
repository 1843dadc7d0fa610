/// \file
/// Which of many things are near a point.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace settle::compare {

/// Parallel to the axes; things in the plane have one coordinate in common [m].
struct Box {
  std::array<double, 3> lowest{}, highest{};
};

/// A lattice of bins over a box; what is beyond it counts to the bins at its edge.
class Bins {
public:
  /// Things with these boxes, known by their numbers: about one a bin. Coordinates are finite [m].
  explicit Bins(const std::vector<Box>& boxes);

  /// The numbers of all things in bins that this box touches: each once, in ascending order. Those that touch the box
  /// itself are among them.
  [[nodiscard]] std::vector<std::size_t> near(const Box& box) const;
  /// Edge of a bin, the longest one [m].
  [[nodiscard]] double edge() const;

private:
  [[nodiscard]] double extent(std::size_t axis) const { return all_.highest[axis] - all_.lowest[axis]; }
  [[nodiscard]] std::size_t bin_along(std::size_t axis, double at) const;
  template <class Visit>
  void visit(const Box& box, const Visit& visit) const;

  Box all_; ///< around everything
  std::array<std::size_t, 3> count_{1, 1, 1};
  std::vector<std::vector<std::size_t>> bins_;
};

} // namespace settle::compare
