#include <cmath>

#include <fmt/format.h>

#include "format.hpp"
#include "html_parts.hpp"
#include "quantity_unit.hpp"

namespace settle::compare::report {

namespace {

/// A line of the table: a part of the difference, or what is known of the inside of one.
struct Part {
  std::string title;
  double value;
  std::string how;
  bool is_largest = false;
};

std::string layers_text(const DifferenceSplit& split) {
  if (std::isnan(split.layers)) return "the limit of many layers is not known for this case";
  return fmt::format("(exact − its limit of infinitely many layers), MPM’s model minus FEM’s; alone they are {} and {}",
                     ratio(split.mpm_layers), ratio(split.fem_layers));
}

/// The three that make up the difference at every probe.
std::vector<Part> sum_of(const DifferenceSplit& split) {
  std::vector<Part> parts{
      {"MPM discretisation", split.mpm_error, "MPM − exact solution of what MPM solves"},
      {"Model difference", split.model_difference,
       "exact solution of what MPM solves − exact solution of what FEM solves, both in closed form"},
      {"FEM discretisation", split.fem_error, "exact solution of what FEM solves − FEM"}};
  double largest = 0.0;
  for (const Part& part : parts)
    largest = part.value > largest ? part.value : largest; // a NaN is never the largest
  for (Part& part : parts)
    part.is_largest = part.value == largest && largest > 0.0;
  return parts;
}

std::vector<Part> parts_of(const DifferenceSplit& split) {
  const std::vector<Part> sum = sum_of(split);
  const bool known = !std::isnan(split.mpm_mass);
  const std::string unknown = "how this case answers to a load on its surface is not known";
  const std::string unbalanced = "the larger of |base reaction − weight| and the stated imbalance, last stage, as a "
                                 "load on the exact column’s surface";
  return {{"MPM − FEM", split.total, "as measured"},
          sum[0],
          {"· refill quantum", split.mpm_mass,
           known ? "weight of MPM’s mass − exact mass, last stage, as a load on the exact column’s surface" : unknown},
          {"· unbalanced force of MPM", split.mpm_unbalanced, known ? unbalanced : unknown},
          sum[1],
          {"· number of layers", split.layers, layers_text(split)},
          sum[2],
          {"· unbalanced force of FEM", split.fem_unbalanced, known ? unbalanced : unknown}};
}

} // namespace

Table split_table(const DifferenceSplit& split, int dimension) {
  const std::string unit = unit_of(split.quantity, dimension);
  Table table{fmt::format("{}: parts of MPM − FEM, l2 over probes after the last stage, relative to {} {}",
                          name_of(split.quantity), number(split.scale), unit),
              {{"Part", "", false}, {"Relative", "", true}, {"l2", unit, true}, {"How it is computed", "", false}},
              {}};
  for (const Part& part : parts_of(split)) {
    const Cell relative = part.is_largest ? Cell{.text = ratio(part.value) + ", largest", .badge = "unheld"}
                                          : Cell{.text = ratio(part.value)};
    table.rows.push_back(
        {{.text = part.title}, relative, {.text = number(part.value * split.scale, 3)}, {.text = part.how}});
  }
  return table;
}

} // namespace settle::compare::report
