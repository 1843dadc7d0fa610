#include "motion_consistency.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "settle/exchange/plane_geometry.hpp"

namespace settle::exchange {
namespace {

void check_time(const Case& study, Reading& reading) {
  const std::string duration = fmt::format("motion.duration = {}", *study.motion->duration);
  if (study.construction.layers != 1)
    reading.complain({.where = study.where("construction.layers"),
                      .what = "a motion in time has a single layer",
                      .given = fmt::format("{} with {}", study.construction.layers, duration),
                      .allowed = "1",
                      .remedy = "leave out motion.duration for a construction by layers"});
  const Mpm& mpm = study.mpm;
  if (mpm.scheme == Scheme::explicit_dynamic && mpm.explicit_dynamic.damping != 0)
    reading.complain({.where = study.where("mpm.explicit.damping"),
                      .what = "damping would change the motion that the case knows",
                      .given = fmt::format("{} with {}", mpm.explicit_dynamic.damping, duration),
                      .allowed = "0",
                      .remedy = "set mpm.explicit.damping = 0"});
}

/// The corners of the polygons, and between each of them and the middle a point that is nowhere special.
std::vector<PlanePoint> samples_of(const Geometry& geometry) {
  constexpr double share = 0.618;
  std::vector<PlanePoint> samples;
  for (const Polygon& polygon : geometry.polygons) {
    PlanePoint middle{0, 0};
    for (const auto& corner : polygon.corners)
      for (std::size_t d = 0; d < 2; ++d)
        middle[d] += corner[d] / static_cast<double>(polygon.corners.size());
    for (const auto& corner : polygon.corners) {
      samples.push_back({corner[0], corner[1]});
      samples.push_back({share * corner[0] + (1 - share) * middle[0], share * corner[1] + (1 - share) * middle[1]});
    }
  }
  return samples;
}

} // namespace

void check_motion(const Case& study, Reading& reading) {
  if (study.motion->duration) check_time(study, reading);
}

void check_start(const Case& study, const Formulas& formulas, Reading& reading) {
  if (!study.motion->duration) return;
  const double round_off = 1e-12 * (study.geometry.width + study.geometry.height);
  for (const PlanePoint& at : samples_of(study.geometry)) {
    const auto [x, y] = formulas.displacement({.x = at[0], .y = at[1]});
    if (std::hypot(x, y) <= round_off) continue; // not so for what is no number
    return reading.complain(
        {.where = study.where("motion.displacement"),
         .what = "motion.displacement is not zero at the start",
         .given = fmt::format("({:.6g}, {:.6g}) at X = {:.6g}, Y = {:.6g}, t = 0", x, y, at[0], at[1]),
         .allowed = "(0, 0) at t = 0: a motion with a duration starts where material is placed",
         .remedy = "shift the formulas in time, or subtract their values at t = 0"});
  }
}

} // namespace settle::exchange
