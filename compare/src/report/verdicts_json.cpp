#include <nlohmann/json.hpp>

#include "format.hpp"
#include "key_figures.hpp"
#include "reported_verdicts.hpp"

namespace settle::compare {

namespace {

using nlohmann::ordered_json;

ordered_json to_json(const Verdict& verdict) {
  return {{"status", name_of(verdict.status)},
          {"run", verdict.run},
          {"kind", verdict.kind},
          {"what", verdict.what},
          {"value", verdict.value},
          {"at_least", verdict.at_least},
          {"limit", verdict.limit},
          {"scale", verdict.scale},
          {"why", verdict.why},
          {"where", verdict.where},
          {"message", report::printable(verdict.message)},
          {"quantity", verdict.quantity},
          {"leg", verdict.leg},
          {"margin", report::margin(verdict)}};
}

ordered_json to_json(const report::KeyFigure& figure) {
  return {{"run", figure.run},
          {"source", figure.source},
          {"figure", exchange::name_of(figure.statistic)},
          {"unit", report::si_unit(figure.statistic)},
          {"value", figure.value},
          {"exact", figure.exact},
          {"relative_difference", report::relative_difference(figure)}};
}

} // namespace

std::string verdicts_json(const CampaignOutcome& outcome) {
  const std::vector<Verdict> verdicts = report::all_verdicts(outcome);
  ordered_json counts;
  for (const auto& [status, number] : report::count(verdicts))
    counts[std::string(name_of(status))] = number;
  ordered_json list = ordered_json::array();
  for (const Verdict& verdict : verdicts)
    list.push_back(to_json(verdict));
  ordered_json figures = ordered_json::array();
  for (const report::KeyFigure& figure : report::key_figures_of(outcome))
    figures.push_back(to_json(figure));
  const ordered_json document{{"format", "settle-verdicts"},
                              {"campaign", outcome.campaign.title},
                              {"program_version", outcome.program_version},
                              {"commit", outcome.commit},
                              {"created", outcome.created},
                              {"status", name_of(worst(verdicts))},
                              {"counts", counts},
                              {"verdicts", list},
                              {"figures", figures}};
  return document.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

} // namespace settle::compare
