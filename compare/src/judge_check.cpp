#include <cmath>

#include <fmt/format.h>

#include "leg_region.hpp"
#include "quantity_unit.hpp"
#include "settle/compare/field_samples.hpp"
#include "settle/compare/judge.hpp"
#include "settle/compare/legs.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/formulas.hpp"

namespace settle::compare {

using exchange::Check;
using exchange::CheckStages;
using exchange::Over;

namespace {

LegRequest request_of(const RunOutcome& run, const Check& check) {
  const auto [value, reference] = value_and_reference(run, check.between);
  LegRequest request{.value = value,
                     .reference = reference,
                     .quantity = check.quantity,
                     .over = check.over,
                     .region = check.region,
                     .stage = run.study.n_stages(),
                     .layers = check.layers,
                     .support = check.support.value_or(0)};
  if (!check.exact.empty()) request.exact = exchange::value_of(run.study, check.exact, "check.exact");
  request.over = place_of(run, request);
  return request;
}

std::string description(const RunOutcome& run, const Check& check, const LegRequest& request) {
  std::string text = fmt::format("{}, {} - {}", name_of(check.quantity), request.value, request.reference);
  if (is_field(check.quantity)) text += fmt::format(", {} over {}", name_of(check.norm), name_of(request.over));
  if (check.region != exchange::Region::whole) text += fmt::format(" {}", text_of(check.region));
  if (!check.layers.empty() && is_field(check.quantity)) {
    text += fmt::format(", layers {} to {}", check.layers.front(), check.layers.back());
  }
  if (check.stages == CheckStages::all) {
    return text + (run.study.n_stages() > 1 ? ", worst of all stages" : ", last stage");
  }
  return text + ", last stage";
}

std::string scale_text(const Check& check, const LegRequest& request, double scale, int dimension) {
  const std::string unit = unit_of(check.quantity, dimension);
  if (check.scale) return fmt::format("{:.6g} {}", scale, unit);
  const std::string norm = is_field(check.quantity) ? fmt::format("{} norm of ", name_of(check.norm)) : "";
  return fmt::format("{}{}: {:.6g} {}", norm, request.reference, scale, unit);
}

/// Measures one stage and keeps it where it is worse than what the verdict holds already. False: nothing to judge.
bool measure(const RunOutcome& run, const Check& check, const LegRequest& request, Verdict& verdict) {
  const LegSamples samples = leg_samples(run, request);
  const RelativeNorm norm = relative_norm(samples, check.norm, check.scale);
  if (!norm.problem.empty()) {
    verdict.value = std::nan("");
    verdict.message = norm.problem;
    if (check.stages == CheckStages::all) verdict.message += fmt::format(" (stage {})", request.stage);
    return false;
  }
  if (!std::isnan(verdict.value) && norm.value <= verdict.value) return true;
  verdict.value = norm.value;
  verdict.scale = scale_text(check, request, norm.scale, run.study.geometry.dimension);
  if (check.stages == CheckStages::all) verdict.scale += fmt::format(", stage {}", request.stage);
  if (samples.without_partner > 0) {
    verdict.scale += fmt::format("; {} points compared, {} without a partner", samples.size(), samples.without_partner);
  }
  return true;
}

void measure_all(const RunOutcome& run, const Check& check, LegRequest request, Verdict& verdict) {
  const int last = run.study.n_stages();
  if (check.quantity == exchange::Quantity::failure_height)
    return static_cast<void>(measure(run, check, request, verdict));
  int first = check.stages == CheckStages::all ? 1 : last;
  if (!check.layers.empty() && is_field(check.quantity)) first = std::max(first, check.layers.front());
  for (request.stage = first; request.stage <= last; ++request.stage) {
    if (!measure(run, check, request, verdict)) return;
  }
}

} // namespace

Verdict judge_check(const RunOutcome& run, const Check& check) {
  const LegRequest request = request_of(run, check);
  Verdict verdict{.run = run.name,
                  .what = description(run, check, request),
                  .kind = "check",
                  .at_least = check.at_least,
                  .limit = check.limit,
                  .why = check.why,
                  .quantity = std::string(name_of(check.quantity)),
                  .leg = fmt::format("{} - {}", request.value, request.reference)};
  try {
    measure_all(run, check, request, verdict);
    hold_to_limits(verdict);
  } catch (const exchange::InputError& error) {
    verdict.status = Status::error;
    verdict.message = error.what();
  }
  return verdict;
}

} // namespace settle::compare
