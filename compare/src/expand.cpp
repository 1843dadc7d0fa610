#include "settle/compare/expand.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/compare/refinement_levels.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/spelling.hpp"

namespace settle::compare {

using exchange::InputError;

namespace {

using Settings = std::vector<std::pair<std::string, std::string>>; ///< dotted key, TOML value

/// All combinations of a matrix; one empty combination where there is none.
std::vector<Settings> combinations(const std::map<std::string, std::vector<std::string>>& matrix) {
  std::vector<Settings> all{{}};
  for (const auto& [key, values] : matrix) {
    std::vector<Settings> longer;
    for (const Settings& settings : all) {
      for (const std::string& value : values) {
        longer.push_back(settings);
        longer.back().emplace_back(key, value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

/// The steps of a zip; one empty step where there is none. Throws InputError for lists that are not of one length.
std::vector<Settings> steps(const std::map<std::string, std::vector<std::string>>& zip, const std::string& file) {
  if (zip.empty()) return {{}};
  const auto& [first_key, first_values] = *zip.begin();
  std::vector<Settings> all(first_values.size());
  for (const auto& [key, values] : zip) {
    if (values.size() != all.size()) {
      throw InputError({.where = file,
                        .what = fmt::format("the lists of a zip are not of one length: {} and {}", first_key, key),
                        .given = fmt::format("{} and {} values", all.size(), values.size()),
                        .allowed = "lists of one length, which run in step",
                        .remedy = "use matrix for every combination"});
    }
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i].emplace_back(key, values[i]);
  }
  return all;
}

/// Every step of the zip with every combination of the matrix.
std::vector<Settings> variations(const RunEntry& entry, const std::string& file) {
  std::vector<Settings> all;
  for (const Settings& step : steps(entry.zip, file)) {
    for (const Settings& combination : combinations(entry.matrix)) {
      all.push_back(step);
      all.back().insert(all.back().end(), combination.begin(), combination.end());
    }
  }
  return all;
}

/// A key is varied in one way only.
void require_varied_once(const RunEntry& entry, const std::string& file) {
  for (const auto& [key, values] : entry.zip) {
    if (!entry.matrix.contains(key)) continue;
    throw InputError({.where = file,
                      .what = fmt::format("the run \"{}\" varies a key twice", entry.name),
                      .given = key + " in matrix and in zip",
                      .allowed = "each key in one of the two",
                      .remedy = {}});
  }
}

std::string without_quotes(const std::string& value) {
  const bool quoted =
      value.size() >= 2 && value.front() == value.back() && (value.front() == '"' || value.front() == '\'');
  return quoted ? value.substr(1, value.size() - 2) : value;
}

std::string name_with(const std::string& pattern, const Settings& settings, const std::string& file) {
  std::string name = pattern;
  for (const auto& [key, value] : settings) {
    const std::string placeholder = "{" + key + "}";
    for (std::size_t at = name.find(placeholder); at != std::string::npos; at = name.find(placeholder, at)) {
      name.replace(at, placeholder.size(), without_quotes(value));
    }
  }
  if (name.find_first_of("{}") != std::string::npos) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : settings)
      keys.push_back("{" + key + "}");
    throw InputError({.where = file,
                      .what = "the name of a run has a placeholder that is no key of its matrix or zip",
                      .given = pattern,
                      .allowed = fmt::format("{}", fmt::join(keys, ", ")),
                      .remedy = {}});
  }
  return name;
}

/// What stands in the checks of a case is a solver that is known, one of its references, or the exact solution.
void require_known_sides(const Campaign& campaign, const exchange::Case& study) {
  std::vector<std::string> known = solver_names(campaign.solvers);
  known.emplace_back("exact");
  for (const auto& [name, reference] : study.references) {
    if (campaign.solvers.contains(name)) {
      throw InputError({.where = study.where("reference." + name),
                        .what = "a reference has the name of a solver",
                        .given = name,
                        .allowed = "a name of its own",
                        .remedy = "give the reference or the solver another name"});
    }
    known.push_back(name);
  }
  for (std::size_t i = 0; i < study.checks.size(); ++i) {
    const std::string key = fmt::format("check.{}.between", i);
    for (const std::string& side : study.checks[i].between) {
      if (const auto complaint = unknown_solver(side, known, study.where(key), key)) throw InputError(*complaint);
    }
  }
}

ExpandedRun make_run(const Campaign& campaign, const RunEntry& entry, const Settings& settings) {
  ExpandedRun run;
  run.name = name_with(entry.name, settings, campaign.file.string());
  run.note = entry.note;
  run.case_file = campaign.file.parent_path() / entry.case_file;
  run.solvers = entry.solvers;
  for (const std::string& solver : entry.solvers) {
    if (const auto found = campaign.solvers.find(solver); found != campaign.solvers.end()) run.joined.insert(*found);
  }
  run.time_limit = entry.time_limit;
  run.memory_limit = entry.memory_limit;
  for (const auto& [key, value] : entry.set)
    run.overrides.push_back(key + "=" + value);
  for (const auto& [key, value] : settings)
    run.overrides.push_back(key + "=" + value);
  run.study = exchange::read_case(run.case_file, run.overrides);
  require_known_sides(campaign, run.study);
  return run;
}

/// The runs of all levels of a refinement family; `base` is the case without them.
std::vector<ExpandedRun> levels_of(const ExpandedRun& base) {
  std::vector<ExpandedRun> runs;
  std::vector<exchange::Case> levels;
  for (const std::vector<std::string>& settings : level_overrides(base.study)) {
    ExpandedRun run = base;
    run.family = base.name;
    run.name = fmt::format("{} level {}", base.name, runs.size() + 1);
    run.overrides.insert(run.overrides.end(), settings.begin(), settings.end());
    run.study = exchange::read_case(run.case_file, run.overrides);
    levels.push_back(run.study);
    runs.push_back(std::move(run));
  }
  require_finer_levels(levels, base.solvers);
  return runs;
}

void require_unique(const std::vector<ExpandedRun>& runs, const std::string& file) {
  std::map<std::string, std::string> known; // folder -> name
  for (const ExpandedRun& run : runs) {
    const auto [other, is_new] = known.try_emplace(folder_name(run.name), run.name);
    if (is_new) continue;
    throw InputError(
        {.where = file,
         .what = "two runs would have one name and one folder",
         .given = fmt::format("{} and {}", other->second, run.name),
         .allowed = "names that are unique after the matrix is expanded",
         .remedy = "put every key of matrix and zip into the name, such as \"column {construction.layers}\""});
  }
}

const ExpandedRun& require_run(const std::vector<ExpandedRun>& runs, const std::string& name, const std::string& user,
                               const std::string& file) {
  const auto found = std::find_if(runs.begin(), runs.end(), [&](const ExpandedRun& run) { return run.name == name; });
  if (found != runs.end()) return *found;
  std::vector<std::string> names;
  for (const ExpandedRun& run : runs)
    names.push_back(run.name);
  const auto nearest = exchange::nearest_spelling(name, names);
  throw InputError({.where = file,
                    .what = user + " names a run that is not there",
                    .given = name,
                    .allowed = fmt::format("{}", fmt::join(names, ", ")),
                    .remedy = nearest ? fmt::format("did you mean {}?", *nearest) : std::string()});
}

void require_source(const ExpandedRun& run, const std::string& source, const std::string& user,
                    const std::string& file) {
  std::vector<std::string> sources{"exact", "exact-fem", "eq-1"};
  for (const std::string& solver : run.solvers) {
    sources.push_back(solver);
    if (solver != "mpm" && solver != "fem") sources.push_back("exact-" + solver);
  }
  for (const auto& [name, reference] : run.study.references)
    sources.push_back(name);
  if (std::find(sources.begin(), sources.end(), source) != sources.end()) return;
  throw InputError({.where = file,
                    .what = fmt::format("{} takes from the run \"{}\" what it does not have", user, run.name),
                    .given = source,
                    .allowed = fmt::format("{}", fmt::join(sources, ", ")),
                    .remedy = {}});
}

void require_figures_fit(const Campaign& campaign, const std::vector<ExpandedRun>& runs) {
  const std::string file = campaign.file.string();
  for (const Figure& figure : campaign.figures) {
    const std::string user = fmt::format("the figure \"{}\"", figure.name);
    for (const Curve& curve : figure.curves) {
      require_source(require_run(runs, curve.run, user, file), curve.source, user, file);
      if (!curve.density_of.empty()) require_run(runs, curve.density_of, user, file);
    }
  }
  for (const Published& number : campaign.published) {
    const std::string user = fmt::format("the published number \"{}\"", number.label);
    require_source(require_run(runs, number.run, user, file), number.source, user, file);
  }
}

} // namespace

std::string folder_name(const std::string& run) {
  std::string name = run;
  for (char& letter : name) {
    const auto code = static_cast<unsigned char>(letter);
    const bool harmless = code < 128 && (std::isalnum(code) != 0 || letter == '.' || letter == '_' || letter == '-');
    if (!harmless) letter = '_';
  }
  return name.empty() || name.front() == '.' ? "_" + name : name;
}

std::vector<ExpandedRun> expand(const Campaign& campaign) {
  std::vector<ExpandedRun> runs;
  for (const RunEntry& entry : campaign.runs) {
    require_varied_once(entry, campaign.file.string());
    for (const Settings& settings : variations(entry, campaign.file.string())) {
      const ExpandedRun run = make_run(campaign, entry, settings);
      const std::vector<ExpandedRun> expanded = entry.converge ? levels_of(run) : std::vector{run};
      runs.insert(runs.end(), expanded.begin(), expanded.end());
    }
  }
  require_unique(runs, campaign.file.string());
  require_figures_fit(campaign, runs);
  return runs;
}

} // namespace settle::compare
