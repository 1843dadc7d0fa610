/// \file
/// Tractions on parts of the surface, carried by the points beside them.
#pragma once

#include <cstdint>
#include <vector>

#include "settle/mpm/body.hpp"
#include "settle/mpm/scattered_sampling.hpp"

namespace settle::mpm {

class LoadCarriers;

/// A small part of a loaded surface, as designed; of a section that is extruded, all along y.
struct LoadedPart {
  Place middle;
  Vector<3> force; ///< along x, y and the height [N], in the plane [N/m]
};

/// The loads of the stages so far. Each is a force on points near the loaded surface and moves with them; their forces
/// and moments are those of the traction on the surface as it was when it came on.
class SurfaceLoads {
public:
  /// Adds a stage's load. `ids`: of all points, of which the carriers are some.
  void add(const std::vector<LoadedPart>& parts, const LoadCarriers& carriers, const std::vector<std::uint64_t>& ids);

  [[nodiscard]] bool empty() const { return forces_.empty(); }
  /// Force per mass on a point while the newest load has this share of its end; valid while the loads are.
  template <int dim>
  [[nodiscard]] PointForce<dim> at(double share_of_newest) const;

private:
  std::vector<std::vector<Vector<3>>> forces_; ///< of each load, by a point's identity - 1; zero beyond its end
};

} // namespace settle::mpm
