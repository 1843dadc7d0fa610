#include "failure_consistency.hpp"

#include <fmt/format.h>

namespace settle::exchange {

void check_failure(const Case& study, Reading& reading) {
  if (!study.construction.may_fail || study.mpm.scheme != Scheme::explicit_dynamic) return;
  const ExplicitDynamic& settings = study.mpm.explicit_dynamic;
  const auto require = [&](bool holds, const std::string& key, Complaint complaint) {
    complaint.where = study.where(key);
    if (!holds) reading.complain(complaint);
  };
  require(study.geometry.drawn() && study.construction.convention != Convention::refill, "construction.may_fail",
          {.where = {},
           .what = "a column between rollers cannot fail, and what is refilled cannot run out",
           .given = fmt::format("may_fail = true with geometry.shape = \"{}\", convention = \"{}\"",
                                name_of(study.geometry.shape), name_of(study.construction.convention)),
           .allowed = "the shapes \"polygons\" and \"embankment\", not refilled, with mpm.scheme = \"explicit\"",
           .remedy = "leave may_fail out, or take another convention for what is drawn"});
  require(settings.relaxation == Relaxation::local, "mpm.explicit.relaxation",
          {.where = {},
           .what = "viscous relaxation has no time in which a body could fail",
           .given = "\"viscous\" with construction.may_fail = true",
           .allowed = "\"local\"",
           .remedy = "leave out mpm.explicit.relaxation"});
  require(!settings.hold, "mpm.explicit.hold",
          {.where = {},
           .what = "whether a body fails is found by holding it until equilibrium",
           .given = fmt::format("{:g} s with construction.may_fail = true", settings.hold.value_or(0.0)),
           .allowed = "\"equilibrium\"",
           .remedy = "leave out mpm.explicit.hold"});
  require(!study.motion, "motion",
          {.where = {},
           .what = "a body that follows a known motion does not fail",
           .given = "[motion] with construction.may_fail = true",
           .allowed = {},
           .remedy = "leave out one of the two"});
}

} // namespace settle::exchange
