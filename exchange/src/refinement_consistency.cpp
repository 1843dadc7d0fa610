#include "refinement_consistency.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace settle::exchange {
namespace {

constexpr std::size_t fewest_levels = 3; // two errors always lie on a line

void check_list(std::size_t length, const std::string& key, const std::string& where, const Case& study,
                Reading& reading) {
  const std::size_t levels = study.converge->levels();
  if (length != levels) {
    reading.complain({.where = where,
                      .what = key + " does not have one value for each level",
                      .given = fmt::format("{} values", length),
                      .allowed = fmt::format("{} values, as many as the other lists of [converge]", levels),
                      .remedy = {}});
  } else if (length < fewest_levels) {
    reading.complain({.where = where,
                      .what = key + " has too few levels for an observed order",
                      .given = fmt::format("{} values", length),
                      .allowed = fmt::format("at least {} levels", fewest_levels),
                      .remedy = "add a finer level"});
  }
}

void check_levels(const Case& study, Reading& reading) {
  const Refinement& refinement = *study.converge;
  for (const auto& [key, values] : refinement.set)
    check_list(values.size(), fmt::format("converge.set.\"{}\"", key), study.where("converge.set"), study, reading);
  if (!refinement.element_size.empty())
    check_list(refinement.element_size.size(), "converge.element_size", study.where("converge.element_size"), study,
               reading);
  if (refinement.levels() == 0) {
    reading.complain({.where = study.where("converge"),
                      .what = "[converge] varies nothing",
                      .given = {},
                      .allowed = "element_size, or a list in set",
                      .remedy = "for example element_size = [0.25, 0.125, 0.0625]"});
  }
  const std::vector<double>& sizes = refinement.element_size;
  if (std::adjacent_find(sizes.begin(), sizes.end(), std::less_equal<>()) == sizes.end()) return;
  if (refinement.size != RefinedSize::element_size) return;
  reading.complain({.where = study.where("converge.element_size"),
                    .what = "converge.element_size does not become smaller with every level",
                    .given = fmt::format("{}", fmt::join(sizes, ", ")),
                    .allowed = "sizes from coarse to fine",
                    .remedy = {}});
}

void check_order(const ExpectedConvergence& expected, const std::string& key, const Case& study, Reading& reading) {
  const bool converging = expected.verdict == Convergence::converging;
  if (converging == expected.order.has_value()) return;
  reading.complain({.where = study.where(key),
                    .what = converging ? key + " expects convergence, but not of which order"
                                       : key + ".order is the order of what is not expected to converge",
                    .given = std::string(name_of(expected.verdict)),
                    .allowed = "an order where verdict is converging, and only there",
                    .remedy = converging ? "add order = 1.0, or what theory gives" : "leave the order out"});
}

void check_expectation(const ExpectedConvergence& expected, const std::string& key, const Case& study,
                       Reading& reading) {
  check_order(expected, key, study, reading);
  if (expected.solver != "mpm" && expected.solver != "fem") {
    reading.complain({.where = study.where(key + ".solver"),
                      .what = key + ".solver names an unknown solver",
                      .given = expected.solver,
                      .allowed = "mpm, fem",
                      .remedy = {}});
  }
  if (expected.over == Over::fields) {
    reading.complain({.where = study.where(key + ".over"),
                      .what = key + ".over is for two solvers, and this is about one",
                      .given = "fields",
                      .allowed = "points, probes",
                      .remedy = {}});
  }
  const bool fits_line = expected.verdict == Convergence::converging && expected.against == ErrorAgainst::exact;
  if (expected.above_fit_at_most && !fits_line) {
    reading.complain({.where = study.where(key + ".above_fit_at_most"),
                      .what = key + ".above_fit_at_most needs a line fitted to errors",
                      .given = fmt::format("{}", *expected.above_fit_at_most),
                      .allowed = "verdict = \"converging\", against = \"exact\"",
                      .remedy = "leave it out"});
  }
}

} // namespace

std::size_t Refinement::levels() const {
  std::size_t most = element_size.size();
  for (const auto& [key, values] : set)
    most = std::max(most, values.size());
  return most;
}

void check_refinement(const Case& study, Reading& reading) {
  check_levels(study, reading);
  for (std::size_t number = 0; number < study.converge->expectations.size(); ++number) {
    check_expectation(study.converge->expectations[number], fmt::format("converge.expect.{}", number), study, reading);
  }
}

} // namespace settle::exchange
