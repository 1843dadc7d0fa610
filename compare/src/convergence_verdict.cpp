#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <fmt/format.h>

#include "settle/compare/convergence.hpp"

namespace settle::compare {

using exchange::Convergence;

namespace {

constexpr std::size_t fewest_levels = 3;

/// What an error does from a level to the next finer one.
enum class Trend { falls, stays, rises };

void require_sizes_fall(const std::vector<double>& sizes, std::size_t count) {
  const bool fall = std::adjacent_find(sizes.begin(), sizes.end(), std::less_equal<>()) == sizes.end();
  if (sizes.size() != count || !fall || (!sizes.empty() && !(sizes.back() > 0.0)))
    throw std::invalid_argument("a refinement study needs one positive size for each value, from coarse to fine");
}

/// Why a sequence cannot be judged; empty where it can.
std::string obstacle(const std::vector<double>& values) {
  if (values.size() < fewest_levels)
    return fmt::format("too few levels: {}, and two always lie on a line", values.size());
  const auto bad = std::find_if_not(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (bad != values.end()) return fmt::format("level {} has no finite value", bad - values.begin() + 1);
  return {};
}

Trend trend_of(double coarse, double fine, double order, const ConvergenceRules& rules) {
  if (fine <= rules.round_off) return coarse <= rules.round_off ? Trend::stays : Trend::falls;
  if (coarse <= rules.round_off || order < -rules.least_order) return Trend::rises;
  return order > rules.least_order ? Trend::falls : Trend::stays;
}

std::vector<Trend> trends_of(const std::vector<double>& errors, const std::vector<double>& orders,
                             const ConvergenceRules& rules) {
  std::vector<Trend> trends;
  for (std::size_t i = 0; i < orders.size(); ++i)
    trends.push_back(trend_of(errors[i], errors[i + 1], orders[i], rules));
  return trends;
}

/// A sequence that falls and rises: does it turn once, and rise on two pairs of levels or more from there?
bool turns_for_good(const std::vector<Trend>& trends) {
  const auto first_rise = std::find(trends.begin(), trends.end(), Trend::rises);
  return std::find(first_rise, trends.end(), Trend::falls) == trends.end() &&
         std::count(first_rise, trends.end(), Trend::rises) > 1;
}

void settle_trends(const std::vector<Trend>& trends, const ConvergenceRules& rules, ConvergenceFinding& finding) {
  const auto last_fall = std::find(trends.rbegin(), trends.rend(), Trend::falls);
  const bool falls = last_fall != trends.rend();
  const bool rises = std::count(trends.begin(), trends.end(), Trend::rises) > 0;
  const bool flat = !falls && finding.order >= -rules.least_order; // NaN is not flat
  if (rises && falls && !turns_for_good(trends)) {
    finding.verdict = Convergence::oscillating;
    finding.reason = "the error falls between some levels and rises between others";
  } else if (rises && !flat) {
    finding.verdict = Convergence::diverging;
    finding.reason = falls ? "the error falls at first, and rises with every finer level from there"
                           : "the error rises with finer levels and falls nowhere";
  } else if (last_fall != trends.rbegin()) {
    finding.verdict = Convergence::floor_limited;
    finding.reason = fmt::format("from level {} on, the error does not fall any more", trends.rend() - last_fall + 1);
  } else {
    finding.verdict = Convergence::converging;
    finding.reason = "the error falls with the size, down to the finest level";
  }
}

double half_spread(const std::vector<double>& orders) {
  const auto [least, most] = std::minmax_element(orders.begin(), orders.end());
  return orders.size() > 1 ? 0.5 * (*most - *least) : std::nan("");
}

std::vector<double> triplet_orders(const std::vector<double>& sizes, const std::vector<double>& values) {
  std::vector<double> orders;
  for (std::size_t i = 0; i + 2 < values.size(); ++i) {
    orders.push_back(
        grid_convergence({{{sizes[i + 2], values[i + 2]}, {sizes[i + 1], values[i + 1]}, {sizes[i], values[i]}}})
            .order);
  }
  return orders;
}

std::vector<double> changes_of(const std::vector<double>& values, double round_off) {
  double largest = 0.0;
  for (const double value : values)
    largest = std::max(largest, std::abs(value));
  std::vector<double> changes;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    const double change = values[i + 1] - values[i];
    changes.push_back(std::abs(change) <= round_off * largest ? 0.0 : change);
  }
  return changes;
}

void settle_changes(const std::vector<double>& changes, const ConvergenceRules& rules, ConvergenceFinding& finding) {
  const auto [least, most] = std::minmax_element(changes.begin(), changes.end());
  if (changes.back() == 0.0) {
    finding.verdict = Convergence::floor_limited;
    finding.reason = "the two finest levels differ by round-off only";
  } else if (*least < 0.0 && *most > 0.0) {
    finding.verdict = Convergence::oscillating;
    finding.reason = "the changes from level to level have different signs";
  } else if (finding.order > rules.least_order) {
    finding.verdict = Convergence::converging;
    finding.reason = "the changes become smaller, down to the finest level";
  } else {
    finding.verdict = Convergence::diverging;
    finding.reason = "the changes do not become smaller with finer levels";
  }
}

} // namespace

ConvergenceFinding judge_errors(const std::vector<double>& sizes, const std::vector<double>& errors,
                                const ConvergenceRules& rules) {
  require_sizes_fall(sizes, errors.size());
  ConvergenceFinding finding;
  finding.pairwise = pairwise_orders(sizes, errors);
  finding.reason = obstacle(errors);
  if (!finding.reason.empty()) return finding;
  finding.fit = fitted_order(sizes, errors);
  finding.order = finding.fit.order;
  finding.band = finding.fit.standard_error;
  settle_trends(trends_of(errors, finding.pairwise, rules), rules, finding);
  return finding;
}

ConvergenceFinding judge_values(const std::vector<double>& sizes, const std::vector<double>& values,
                                const ConvergenceRules& rules) {
  require_sizes_fall(sizes, values.size());
  ConvergenceFinding finding;
  finding.reason = obstacle(values);
  if (!finding.reason.empty()) return finding;
  finding.pairwise = triplet_orders(sizes, values);
  finding.order = finding.pairwise.back();
  finding.band = half_spread(finding.pairwise);
  settle_changes(changes_of(values, rules.round_off), rules, finding);
  return finding;
}

} // namespace settle::compare
