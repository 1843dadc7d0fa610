#include "case_consistency.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "failure_consistency.hpp"
#include "material_consistency.hpp"
#include "motion_consistency.hpp"
#include "path_consistency.hpp"
#include "polygon_consistency.hpp"
#include "refinement_consistency.hpp"
#include "settle/exchange/formulas.hpp"
#include "settle/exchange/spelling.hpp"
#include "stage_consistency.hpp"

namespace settle::exchange {
namespace {

void check_material(const Case& study, Reading& reading) {
  const std::string& name = study.construction.material;
  if (name.empty() || study.materials.contains(name)) return; // empty: its absence has been complained about
  std::vector<std::string> names;
  for (const auto& [known, material] : study.materials)
    names.push_back(known);
  const auto nearest = nearest_spelling(name, names);
  reading.complain(
      {.where = study.where("construction.material"),
       .what = "construction.material names a material that is not in the case",
       .given = name,
       .allowed = fmt::format("{}", fmt::join(names, ", ")),
       .remedy = nearest ? fmt::format("did you mean {}?", *nearest) : fmt::format("add a table [material.{}]", name)});
}

void check_probe(double position, double extent, const std::string& key, const Case& study, Reading& reading) {
  if (position >= 0 && position <= extent) return;
  reading.complain({.where = study.where(key),
                    .what = key + " lies outside the construction",
                    .given = fmt::format("{}", position),
                    .allowed = fmt::format("from 0 to {} [m]", extent),
                    .remedy = "leave it out for the middle"});
}

void check_probes(const Case& study, Reading& reading) {
  const Geometry& geometry = study.geometry;
  for (const auto& [name, line] : study.probes) {
    const std::string key = "probes." + name;
    if (line.x) check_probe(*line.x, geometry.width, key + ".x", study, reading);
    if (line.y && geometry.depth) check_probe(*line.y, *geometry.depth, key + ".y", study, reading);
  }
}

void check_references(const Case& study, Reading& reading) {
  constexpr std::array<std::string_view, 3> reserved{"mpm", "fem", "exact"};
  for (const auto& [name, reference] : study.references) {
    if (std::find(reserved.begin(), reserved.end(), name) == reserved.end()) continue;
    reading.complain({.where = study.where("reference." + name),
                      .what = fmt::format("reference.{} has a name with a meaning of its own", name),
                      .given = name,
                      .allowed = fmt::format("any name but {}", fmt::join(reserved, ", ")),
                      .remedy = {}});
  }
}

void check_between(const Check& check, const std::string& key, const Case& study, Reading& reading) {
  if (check.between.size() != 2 || check.between[0] != check.between[1]) return;
  reading.complain({.where = study.where(key + ".between"),
                    .what = key + ".between compares something with itself",
                    .given = fmt::format("{}, {}", check.between[0], check.between[1]),
                    .allowed = "two different entries",
                    .remedy = {}});
}

void check_layers(const Check& check, const std::string& key, const Case& study, Reading& reading) {
  if (check.layers.size() != 2) return;
  const int first = check.layers[0], last = check.layers[1], layers = study.construction.layers;
  if (first <= last && last <= layers) return;
  reading.complain({.where = study.where(key + ".layers"),
                    .what = key + ".layers is not a range of the case's layers",
                    .given = fmt::format("[{}, {}]", first, last),
                    .allowed = fmt::format("first and last layer, from 1 to {}", layers),
                    .remedy = {}});
}

/// What has one value and no field, and what that asks for.
struct OneValue {
  std::string key;
  Quantity quantity;
  const std::optional<int>& support;
  const std::string& exact;
};

void check_one_value(const OneValue& asked, const Case& study, Reading& reading) {
  const auto refuse = [&](const std::string& last, const std::string& what, const std::string& given,
                          const std::string& allowed) {
    reading.complain({.where = study.where(asked.key + last),
                      .what = asked.key + last + what,
                      .given = given,
                      .allowed = allowed,
                      .remedy = {}});
  };
  const auto supports = static_cast<int>(study.supports.size());
  const bool of_support = asked.quantity == Quantity::support_reaction;
  if (of_support && (!asked.support || *asked.support > supports))
    refuse(".support", " does not name a support of the case", asked.support ? fmt::format("{}", *asked.support) : "",
           fmt::format("from 1 to {}", supports));
  if (!of_support && asked.support)
    refuse(".support", " is for a support reaction only", std::string(name_of(asked.quantity)), "support-reaction");
  if (asked.exact.empty()) return;
  if (asked.quantity < Quantity::density)
    return refuse(".exact", " gives one value to a field", std::string(name_of(asked.quantity)),
                  "a quantity that has one value");
  static_cast<void>(value_of(study, asked.exact, asked.key + ".exact"));
}

void check_band(const Check& check, const std::string& key, const Case& study, Reading& reading) {
  if (check.at_least <= check.limit) return;
  reading.complain({.where = study.where(key + ".at_least"),
                    .what = key + ".at_least is above its limit, so that nothing could pass",
                    .given = fmt::format("{}", check.at_least),
                    .allowed = fmt::format("from 0 to {}", check.limit),
                    .remedy = {}});
}

bool names_a_reference(const Check& check, const Case& study) {
  return std::any_of(check.between.begin(), check.between.end(),
                     [&](const std::string& name) { return name == "exact" || study.references.contains(name); });
}

/// Has it a value for each stage, not for each point?
bool is_of_a_stage(Quantity quantity) {
  constexpr std::array of_stages{Quantity::density,          Quantity::base_reaction,  Quantity::mass,
                                 Quantity::support_reaction, Quantity::failure_height, Quantity::thrust};
  return std::find(of_stages.begin(), of_stages.end(), quantity) != of_stages.end();
}

/// Fields, and parts of a body.
void check_place(const Check& check, const std::string& key, const Case& study, Reading& reading) {
  const bool over_fields = check.over == Over::fields;
  const std::string of = over_fields ? key + ".over" : key + ".region";
  const std::string given = over_fields ? "fields" : std::string(name_of(check.region));
  if (!over_fields && check.region == Region::whole) return;
  if (!study.geometry.drawn()) {
    reading.complain({.where = study.where(of),
                      .what = of + " is for bodies that are drawn: a column is the same all over its width",
                      .given = given,
                      .allowed = over_fields ? "points, probes" : "whole",
                      .remedy = "leave it out"});
  } else if (is_of_a_stage(check.quantity)) {
    reading.complain(
        {.where = study.where(of),
         .what = fmt::format("{} asks where {} is compared, which no point has", of, name_of(check.quantity)),
         .given = given,
         .allowed = {},
         .remedy = "leave it out"});
  } else if (over_fields && names_a_reference(check, study)) {
    reading.complain({.where = study.where(of),
                      .what = of + " compares two solvers at each other's points",
                      .given = fmt::format("between {}", fmt::join(check.between, " and ")),
                      .allowed = "two solvers",
                      .remedy = "over = \"points\" compares a solver with the exact solution"});
  }
}

/// Relaxation has no time in which a hold could be measured; without a ramp, no hold at all would be no step at all.
void check_relaxation(const Case& study, Reading& reading) {
  const ExplicitDynamic& settings = study.mpm.explicit_dynamic;
  if (settings.relaxation == Relaxation::local || !settings.hold) return;
  reading.complain({.where = study.where("mpm.explicit.hold"),
                    .what = "viscous relaxation leads to equilibrium, not through a time",
                    .given = fmt::format("{:g} s with relaxation = \"viscous\"", *settings.hold),
                    .allowed = "\"equilibrium\"",
                    .remedy = "leave out mpm.explicit.hold, or set mpm.explicit.relaxation = \"local\""});
}

} // namespace

void check_consistency(const Case& study, Reading& reading) {
  check_material(study, reading);
  check_materials(study, reading);
  if (study.geometry.shape == Shape::point)
    check_paths(study, reading);
  else if (study.geometry.drawn())
    check_polygons(study, reading);
  else
    check_probes(study, reading);
  if (study.geometry.shape != Shape::point) check_stages(study, reading);
  check_relaxation(study, reading);
  check_failure(study, reading);
  if (study.motion) check_motion(study, reading);
  check_references(study, reading);
  for (std::size_t number = 0; number < study.checks.size(); ++number) {
    const std::string key = fmt::format("check.{}", number);
    check_between(study.checks[number], key, study, reading);
    check_layers(study.checks[number], key, study, reading);
    check_band(study.checks[number], key, study, reading);
    check_place(study.checks[number], key, study, reading);
    check_one_value({key, study.checks[number].quantity, study.checks[number].support, study.checks[number].exact},
                    study, reading);
  }
  if (!study.converge) return;
  check_refinement(study, reading);
  for (std::size_t number = 0; number < study.converge->expectations.size(); ++number) {
    const ExpectedConvergence& expected = study.converge->expectations[number];
    check_one_value({fmt::format("converge.expect.{}", number), expected.quantity, expected.support, expected.exact},
                    study, reading);
  }
}

} // namespace settle::exchange
