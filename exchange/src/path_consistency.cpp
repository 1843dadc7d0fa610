#include "path_consistency.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

namespace settle::exchange {
namespace {

void check_control(const Case& study, std::size_t number, Reading& reading) {
  for (const std::string& word : study.paths[number].control) {
    if (word == "strain" || word == "stress") continue;
    reading.complain({.where = study.where(fmt::format("path.{}.control", number)),
                      .what = fmt::format("path.{}.control holds an unknown word", number),
                      .given = word,
                      .allowed = "\"strain\" or \"stress\", for each of xx, yy, zz, xy, yz, xz",
                      .remedy = {}});
  }
}

/// All points have legs, and as many as the first.
void check_counts(const Case& study, Reading& reading) {
  std::map<int, int> legs;
  for (const PathLeg& leg : study.paths)
    ++legs[leg.point];
  const int points = legs.empty() ? 0 : legs.rbegin()->first;
  for (int point = 1; point <= points; ++point) {
    if (legs[point] == legs[1]) continue;
    return reading.complain({.where = study.where("path"),
                             .what = fmt::format("point {} has another number of legs than point 1", point),
                             .given = fmt::format("{} and {}", legs[point], legs[1]),
                             .allowed = "as many legs for every point, points numbered from 1 without gaps",
                             .remedy = {}});
  }
}

void refuse_body(const Case& study, const char* key, Reading& reading) {
  const bool given = std::any_of(study.origins.begin(), study.origins.end(), [&](const auto& origin) {
    return origin.first == key || origin.first.starts_with(std::string(key) + ".");
  });
  if (!given) return;
  reading.complain({.where = study.where(key),
                    .what = fmt::format("single material points have no use for {}", key),
                    .given = "geometry.shape = \"point\"",
                    .allowed = {},
                    .remedy = "leave it out"});
}

} // namespace

void fill_paths(Case& study) {
  if (study.geometry.shape == Shape::point && study.initial.stress.empty()) study.initial.stress.assign(6, 0.0);
  for (PathLeg& leg : study.paths)
    if (leg.control.empty()) leg.control.assign(6, "strain");
}

void check_paths(const Case& study, Reading& reading) {
  for (const char* key : {"support", "motion", "probes", "stage"})
    refuse_body(study, key, reading);
  if (study.paths.empty())
    reading.complain({.where = study.where("geometry.shape"),
                      .what = "a material point without a path does nothing",
                      .given = "no [[path]]",
                      .allowed = "at least one",
                      .remedy = "add [[path]] increment = [xx, yy, zz, xy, yz, xz]"});
  if (study.construction.layers != 1)
    reading.complain({.where = study.where("construction.layers"),
                      .what = "single material points are no layers",
                      .given = fmt::format("{}", study.construction.layers),
                      .allowed = "1",
                      .remedy = {}});
  for (std::size_t number = 0; number < study.paths.size(); ++number)
    check_control(study, number, reading);
  check_counts(study, reading);
}

} // namespace settle::exchange
