/// \file
/// Tractions on straight parts of the surface, carried by the points beside them.
#pragma once

#include <functional>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/mpm/scattered_sampling.hpp"

namespace settle::mpm {

/// The loads of the stages so far. Each is a force on points near the loaded line and moves with them; their forces and
/// moments are those of the traction on the line as it was when it came on.
class SurfaceLoads {
public:
  /// Adds a stage's load on points that have their place in a design near the line; `spacing`: of points [m].
  void add(const exchange::StageEntry& entry, const Scattered& points, const Points<2>& all, double spacing);

  [[nodiscard]] bool empty() const { return forces_.empty(); }
  /// Force per mass on a point [m/s2] while the newest load has this share of its end; valid while the loads are.
  [[nodiscard]] std::function<Vector<2>(const Points<2>&, std::size_t)> at(double share_of_newest) const;

private:
  std::vector<std::vector<Vector<2>>> forces_; ///< of each load, by a point's identity - 1; zero beyond its end [N/m]
};

} // namespace settle::mpm
