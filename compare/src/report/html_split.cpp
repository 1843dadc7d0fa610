#include <cmath>

#include <fmt/format.h>

#include "format.hpp"
#include "html_parts.hpp"
#include "profiles.hpp"
#include "quantity_unit.hpp"

namespace settle::compare::report {

namespace {

/// A line of the table: a part of the difference, or what is known of the inside of one.
struct Part {
  std::string title;
  double value;
  std::string remark{};
  bool is_largest = false;
};

std::string layers_text(const DifferenceSplit& split) {
  if (std::isnan(split.layers)) return "";
  return fmt::format("alone {} and {}", ratio(split.mpm_layers), ratio(split.fem_layers));
}

/// The three that make up the difference at every probe.
std::vector<Part> sum_of(const DifferenceSplit& split) {
  std::vector<Part> parts{{"MPM discretisation", split.mpm_error},
                          {"Model difference", split.model_difference},
                          {"FEM discretisation", split.fem_error}};
  double largest = 0.0;
  for (const Part& part : parts)
    largest = part.value > largest ? part.value : largest; // a NaN is never the largest
  for (Part& part : parts)
    part.is_largest = part.value == largest && largest > 0.0;
  return parts;
}

std::vector<Part> parts_of(const DifferenceSplit& split) {
  const std::vector<Part> sum = sum_of(split);
  return {{"MPM − FEM", split.total},
          sum[0],
          {"· refill quantum", split.mpm_mass},
          {"· unbalanced force of MPM", split.mpm_unbalanced},
          sum[1],
          {"· number of layers", split.layers, layers_text(split)},
          sum[2],
          {"· unbalanced force of FEM", split.fem_unbalanced}};
}

} // namespace

Table split_table(const DifferenceSplit& split, int dimension) {
  const std::string unit = unit_of(split.quantity, dimension);
  Table table{fmt::format("{}: parts of MPM − FEM, l2 over probes after the last stage, relative to {} {}",
                          axis_of(split.quantity).title, number(split.scale), unit),
              {{"Part", "", false}, {"Relative", "", true}, {"l2", unit, true}},
              {}};
  for (const Part& part : parts_of(split)) {
    const Cell relative = part.is_largest ? Cell{.text = ratio(part.value) + ", largest", .badge = "unheld"}
                                          : Cell{.text = ratio(part.value)};
    table.rows.push_back(
        {{.text = part.title, .small_print = part.remark}, relative, {.text = number(part.value * split.scale, 3)}});
  }
  return table;
}

Table parts_table() {
  const std::string unbalanced = "the larger of |base reaction − weight| and the stated imbalance, last stage, as a "
                                 "load on the exact column’s surface";
  return {"Parts of a difference between MPM and FEM; those with a dot are inside the part above them",
          {{"Part", "", false}, {"How it is computed", "", false}},
          {{{.text = "MPM − FEM"}, {.text = "as measured"}},
           {{.text = "MPM discretisation"}, {.text = "MPM − exact solution of what MPM solves"}},
           {{.text = "· refill quantum"},
            {.text = "weight of MPM’s mass − exact mass, last stage, as a load on the exact column’s surface"}},
           {{.text = "· unbalanced force of MPM"}, {.text = unbalanced}},
           {{.text = "Model difference"},
            {.text = "exact solution of what MPM solves − exact solution of what FEM solves, both in closed form"}},
           {{.text = "· number of layers"},
            {.text = "(exact − its limit of infinitely many layers), MPM’s model minus FEM’s; below it the two alone"}},
           {{.text = "FEM discretisation"}, {.text = "exact solution of what FEM solves − FEM"}},
           {{.text = "· unbalanced force of FEM"}, {.text = unbalanced}}}};
}

} // namespace settle::compare::report
