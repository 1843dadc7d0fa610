#include "settle/compare/shard.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"

namespace settle::compare {
namespace {

bool read_number(const std::string& text, int& number) {
  const char* end = text.data() + text.size();
  const auto [stop, failure] = std::from_chars(text.data(), end, number);
  return failure == std::errc() && stop == end;
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

std::vector<ExpandedRun> runs_of(const Shard& shard, const std::vector<ExpandedRun>& runs) {
  std::map<std::string, int> families; // name -> its turn
  std::vector<ExpandedRun> part;
  int turn = 0;
  for (const ExpandedRun& run : runs) {
    const bool is_alone = run.family.empty();
    const int mine = is_alone ? turn++ : families.try_emplace(run.family, turn).first->second;
    if (!is_alone && mine == turn) ++turn;
    if (mine % shard.count == shard.index - 1) part.push_back(run);
  }
  if (!part.empty()) return part;
  throw exchange::InputError({.where = "--shard",
                              .what = "there are more parts than runs",
                              .given = fmt::format("{}/{}", shard.index, shard.count),
                              .allowed = fmt::format("at most {} parts (a refinement family is one run)", turn),
                              .remedy = {}});
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
