#include "settle/compare/convergence_text.hpp"

#include <cmath>

#include <fmt/format.h>

namespace settle::compare {
namespace {

std::string finite(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : std::string();
}

std::string order_text(double order) {
  return std::isfinite(order) ? fmt::format("{:.2f}", order) : std::string();
}

std::string expected_text(const ConvergenceStudy& study) {
  if (!study.is_expected) return "nothing is expected";
  const exchange::ExpectedConvergence& expected = study.expected;
  std::string text = fmt::format("expected: {}", name_of(expected.verdict));
  if (expected.order) {
    text += fmt::format(" at order {:.3g}, {:.3g} to {:.3g}", *expected.order, *expected.order - expected.band.front(),
                        *expected.order + expected.band.back());
  }
  return text;
}

/// The error of level i, or the change that led to it.
double shown_error(const ConvergenceStudy& study, std::size_t i) {
  if (!study.errors.empty()) return study.errors[i];
  return i == 0 ? std::nan("") : std::abs((study.values[i] - study.values[i - 1]) / study.values[i]);
}

} // namespace

std::vector<ConvergenceRow> rows_of(const ConvergenceStudy& study) {
  std::vector<ConvergenceRow> rows;
  for (std::size_t i = 0; i < study.values.size(); ++i) {
    ConvergenceRow row{finite(study.sizes[i], 6), finite(study.values[i], 6), finite(shown_error(study, i), 4), {}};
    const std::size_t before = study.errors.empty() ? 2 : 1; // levels that an order needs besides this one
    const std::vector<double>& orders = study.finding.pairwise;
    if (i >= before && i - before < orders.size()) row.order = order_text(orders[i - before]);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string conclusion_of(const ConvergenceStudy& study) {
  if (!study.problem.empty()) return study.problem;
  const ConvergenceFinding& finding = study.finding;
  std::string text(exchange::name_of(finding.verdict));
  if (std::isfinite(finding.order)) {
    text += fmt::format(", {}order {:.2f}", study.errors.empty() ? "" : "fitted ", finding.order);
    if (std::isfinite(finding.band)) text += fmt::format(" ± {:.2f}", finding.band);
  }
  return fmt::format("{} ({}); {}", text, expected_text(study), finding.reason);
}

std::string extrapolation_of(const ConvergenceStudy& study) {
  const GridConvergence& grid = study.grid;
  if (!(grid.order > 0.0)) return {};
  std::string text = fmt::format("norms of the three finest levels: order {:.2f}, extrapolated {:.6g} {}", grid.order,
                                 grid.extrapolated, study.unit);
  if (!study.exact.empty()) text += fmt::format(" (exact {:.6g})", study.exact.back());
  return text + fmt::format(", grid convergence index {:.3g} %, asymptotic ratio {:.3f}", 100.0 * grid.fine_index,
                            grid.asymptotic_ratio);
}

} // namespace settle::compare
