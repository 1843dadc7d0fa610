/// \file
/// What lies near a part of a body's boundary.
#pragma once

#include <optional>
#include <vector>

#include "bins.hpp"
#include "boundary_sides.hpp"
#include "free_surface.hpp"

namespace settle::compare {

/// A band along a part of the boundary, told by the lines of a section, or by the sides of a body that varies along y.
class BoundaryBand {
public:
  /// Along the free surface at a stage, and along what the body stands on; `width` [m].
  static BoundaryBand along_free_surface(const exchange::Case& study, int stage, double width);
  static BoundaryBand along_base(const exchange::Case& study, double width);

  /// Is there no such part of the boundary?
  [[nodiscard]] bool empty() const { return lines_.empty() && sides_.empty(); }
  /// Is a point not further from it than the width? x, y and the height, as placed or in the design geometry [m].
  [[nodiscard]] bool holds(const exchange::SolidPoint& point) const;

private:
  BoundaryBand(std::vector<BoundaryPart> lines, std::vector<BoundarySide> sides, double width);

  std::vector<BoundaryPart> lines_;
  std::vector<BoundarySide> sides_;
  std::optional<Bins> bins_; ///< of the sides
  double width_;
};

} // namespace settle::compare
