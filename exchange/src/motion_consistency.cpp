#include "motion_consistency.hpp"

#include <fmt/format.h>

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

} // namespace

void check_motion(const Case& study, Reading& reading) {
  if (study.motion->duration) check_time(study, reading);
}

} // namespace settle::exchange
