#include "valley_consistency.hpp"

#include <fmt/format.h>

namespace settle::exchange {
namespace {

void require(bool holds, const Complaint& complaint, Reading& reading) {
  if (!holds) reading.complain(complaint);
}

} // namespace

void check_valley(const Case& study, Reading& reading) {
  const Geometry& geometry = study.geometry;
  const Valley& valley = *geometry.valley;
  require(geometry.dimension == 3,
          {.where = study.where("geometry.valley"),
           .what = "a dam across a valley is a body in space",
           .given = fmt::format("geometry.valley with geometry.dimension = {}", geometry.dimension),
           .allowed = "geometry.dimension = 3",
           .remedy = "set it, or leave out geometry.valley"},
          reading);
  require(!study.origins.contains("geometry.depth"),
          {.where = study.where("geometry.depth"),
           .what = "in a valley the flanks say how deep the body is",
           .given = fmt::format("geometry.depth = {} with geometry.valley", geometry.depth.value_or(0.0)),
           .allowed = "one of the two",
           .remedy = "leave out geometry.depth"},
          reading);
  require(geometry.embankment->foundation_depth == 0,
          {.where = study.where("geometry.embankment.foundation_depth"),
           .what = "the floor of a valley is rigid, without ground on it",
           .given = fmt::format("foundation_depth = {} with geometry.valley", geometry.embankment->foundation_depth),
           .allowed = "0",
           .remedy = "leave out the foundation, or geometry.valley"},
          reading);
  require(valley.bottom + valley.slopes[0] + valley.slopes[1] > 0,
          {.where = study.where("geometry.valley.bottom"),
           .what = "the valley has no width",
           .given = "a floor of 0 m between vertical flanks",
           .allowed = "a floor, or a flank with a slope",
           .remedy = {}},
          reading);
}

} // namespace settle::exchange
