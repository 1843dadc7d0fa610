/// \file
/// Outlines divided into convex polygons.
#pragma once

#include <optional>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// Polygons are given by the numbers of their nodes in a plane mesh, anticlockwise.
class ConvexParts {
public:
  using Corners = std::vector<unsigned>;

  /// The mesh has to outlive this.
  explicit ConvexParts(const Mesh& mesh);

  /// [m2]
  [[nodiscard]] double area(const Corners& polygon) const;

  /// Of outlines that do not cross themselves and hold no hole: those that are convex as they are; others are cut into
  /// triangles, ear by ear, which are merged again (Hertel and Mehlhorn 1983: no more than four times as many parts as
  /// are needed).
  [[nodiscard]] std::vector<Corners> of_outlines(const std::vector<Corners>& outlines) const;

  /// Convex polygons joined with neighbours, across all of the edges that they share, as long as they stay convex.
  [[nodiscard]] std::vector<Corners> merged(std::vector<Corners> parts) const;

private:
  [[nodiscard]] double turn(unsigned a, unsigned b, unsigned c) const;
  [[nodiscard]] bool is_convex(const Corners& polygon) const;
  [[nodiscard]] bool is_ear(const Corners& polygon, std::size_t at) const;
  [[nodiscard]] std::vector<Corners> triangles(Corners outline) const;
  [[nodiscard]] std::optional<Corners> joined(const Corners& one, const Corners& other) const;
  [[nodiscard]] Corners without_straight_corners(const Corners& polygon) const;

  const Mesh& mesh_;
  double slack_; ///< distance that is round-off [m]
};

} // namespace settle::exchange
