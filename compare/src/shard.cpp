#include "settle/compare/shard.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare {
namespace {

bool read_number(const std::string& text, int& number) {
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, number);
  return failure == std::errc() && stop == end;
}

/// What is dealt out as one, each the indices of its runs: a run, or a refinement family.
std::vector<std::vector<std::size_t>> units_of(const std::vector<ExpandedRun>& runs) {
  std::vector<std::vector<std::size_t>> units;
  std::map<std::string, std::size_t> families; // name -> its unit
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const std::string& family = runs[run].family;
    const bool is_new = family.empty() || families.try_emplace(family, units.size()).second;
    if (is_new) units.emplace_back();
    (is_new ? units.back() : units[families.at(family)]).push_back(run);
  }
  return units;
}

/// The cost of each unit [s]; of a run that is not known, the mean of those that are.
std::vector<double> costs_of(const std::vector<std::vector<std::size_t>>& units, const std::vector<ExpandedRun>& runs,
                             const RunCosts& costs) {
  double sum = 0;
  std::size_t known = 0;
  for (const ExpandedRun& run : runs) {
    const auto found = costs.find(run.name);
    if (found == costs.end()) continue;
    sum += found->second;
    ++known;
  }
  const double mean = known > 0 ? sum / static_cast<double>(known) : 1.0;
  std::vector<double> of_units;
  for (const std::vector<std::size_t>& unit : units) {
    double& cost = of_units.emplace_back(0.0);
    for (const std::size_t run : unit) {
      const auto found = costs.find(runs[run].name);
      cost += found != costs.end() ? found->second : mean;
    }
  }
  return of_units;
}

/// The part of each unit, 0 ... parts - 1.
std::vector<int> in_turn(std::size_t units, int parts) {
  std::vector<int> dealt;
  for (std::size_t unit = 0; unit < units; ++unit)
    dealt.push_back(static_cast<int>(unit % static_cast<std::size_t>(parts)));
  return dealt;
}

/// The same, the longest first, each to the part with least to do. As many parts as there are units get one at least.
std::vector<int> by_cost(const std::vector<double>& costs, int parts) {
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
  std::vector<std::pair<double, int>> loads(static_cast<std::size_t>(parts)); // cost [s], units
  std::vector<int> dealt(costs.size());
  for (const std::size_t unit : order) {
    const auto least = std::min_element(loads.begin(), loads.end());
    dealt[unit] = static_cast<int>(least - loads.begin());
    least->first += costs[unit];
    ++least->second;
  }
  return dealt;
}

bool is_possible(const Figure& figure, const std::set<std::string>& runs) {
  return std::all_of(figure.curves.begin(), figure.curves.end(), [&](const Curve& curve) {
    return runs.contains(curve.run) && (curve.density_of.empty() || runs.contains(curve.density_of));
  });
}

} // namespace

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  Shard shard;
  const bool two_numbers = slash != std::string::npos && read_number(text.substr(0, slash), shard.index) &&
                           read_number(text.substr(slash + 1), shard.count);
  if (two_numbers && 1 <= shard.index && shard.index <= shard.count) return shard;
  throw exchange::InputError({.where = "--shard",
                              .what = "this is no part of a campaign",
                              .given = text,
                              .allowed = "i/n with 1 <= i <= n",
                              .remedy = "for example --shard 2/3, the second of three parts"});
}

RunCosts read_costs(const std::filesystem::path& file) {
  RunCosts costs;
  try {
    const auto stored = nlohmann::json::parse(read_text(file));
    for (const auto& run : stored.at("runs")) {
      double& cost = costs[run.at("name")];
      for (const auto& solver : run.at("solvers"))
        cost += solver.at("wall_time").get<double>();
    }
  } catch (const nlohmann::json::exception& error) {
    throw exchange::FileError({.where = file.string(),
                               .what = "this is no outcome of a campaign",
                               .given = error.what(),
                               .allowed = "outcome.json of an earlier campaign",
                               .remedy = "leave --costs out: runs are then dealt out in turn"});
  }
  return costs;
}

std::vector<ExpandedRun> runs_of(const Shard& shard, const std::vector<ExpandedRun>& runs, const RunCosts& costs) {
  const std::vector<std::vector<std::size_t>> units = units_of(runs);
  if (units.size() < static_cast<std::size_t>(shard.index))
    throw exchange::InputError(
        {.where = "--shard",
         .what = "there are more parts than runs",
         .given = fmt::format("{}/{}", shard.index, shard.count),
         .allowed = fmt::format("at most {} parts (a refinement family is one run)", units.size()),
         .remedy = {}});
  const std::vector<double> unit_costs = costs_of(units, runs, costs);
  const std::vector<int> dealt = costs.empty() ? in_turn(units.size(), shard.count) : by_cost(unit_costs, shard.count);
  std::vector<std::size_t> mine;
  for (std::size_t unit = 0; unit < units.size(); ++unit) {
    if (dealt[unit] == shard.index - 1) mine.insert(mine.end(), units[unit].begin(), units[unit].end());
  }
  std::sort(mine.begin(), mine.end());
  std::vector<ExpandedRun> part;
  for (const std::size_t run : mine)
    part.push_back(runs[run]);
  return part;
}

Campaign campaign_of(const Shard& shard, Campaign campaign, const std::vector<ExpandedRun>& runs,
                     std::size_t all_runs) {
  std::set<std::string> names;
  for (const ExpandedRun& run : runs)
    names.insert(run.name);
  const std::size_t figures = campaign.figures.size();
  std::erase_if(campaign.figures, [&](const Figure& figure) { return !is_possible(figure, names); });
  std::erase_if(campaign.published, [&](const Published& number) { return !names.contains(number.run); });
  campaign.title += fmt::format(" (shard {} of {})", shard.index, shard.count);
  campaign.description += fmt::format(
      "{}This is shard {} of {}: {} of {} runs; {} of {} figures need runs of other shards and are left out.",
      campaign.description.empty() ? "" : "\n\n", shard.index, shard.count, runs.size(), all_runs,
      figures - campaign.figures.size(), figures);
  return campaign;
}

} // namespace settle::compare
