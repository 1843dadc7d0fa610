#include "settle/compare/campaign_io.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/key_table.hpp"

namespace settle::compare {

using exchange::KeyTable;
namespace document = exchange::document;

namespace {

KeyTable<RunEntry> run_keys() {
  KeyTable<RunEntry> keys("A case, the solvers that run it, what is set and what is varied.");
  keys.text("name", &RunEntry::name,
            {.required = true,
             .doc = "unique; {construction.layers} in it stands for the value of that key of matrix or zip"});
  keys.text("case", &RunEntry::case_file, {.required = true, .doc = "the case file, relative to the campaign file"});
  keys.texts("solvers", &RunEntry::solvers, {.count = {.least = 1}, .doc = "mpm, fem, or the NAME of a [solver.NAME]"});
  keys.toml_values("set", &RunEntry::set, {.doc = "keys of the case that are set for the whole run"});
  keys.toml_lists("matrix", &RunEntry::matrix,
                  {.doc = "keys of the case that are varied; every combination of their values is a run"});
  keys.toml_lists("zip", &RunEntry::zip,
                  {.doc =
                       "keys of the case that are varied in step: the first values of all are a run, then the second "
                       "ones; with a matrix, each of these with every combination"});
  keys.boolean("converge", &RunEntry::converge,
               {.doc = "run the levels of the case's [converge] and judge how they converge"});
  keys.real("time_limit", &RunEntry::time_limit,
            {.unit = "s", .range = exchange::above(0), .doc = "wall time of one solver, after which it is stopped"});
  keys.real("memory_limit", &RunEntry::memory_limit,
            {.unit = "B",
             .range = exchange::above(0),
             .left_out = "nine tenths of the machine's",
             .doc = "memory of one solver, above which it is stopped"});
  keys.text("note", &RunEntry::note, {.doc = "shown in the report: what the run is for, what is known to differ"});
  return keys;
}

KeyTable<Curve> curve_keys() {
  KeyTable<Curve> keys("A curve of a figure.");
  keys.text("run", &Curve::run, {.required = true, .doc = "a run, by its name after expansion"});
  keys.text(
      "source", &Curve::source,
      {.required = true,
       .doc =
           "a solver, exact (of what mpm solves), exact-SOLVER (of what that one solves), eq-1, or the name of one of "
           "the case's references"});
  keys.text("label", &Curve::label, {.doc = "shown in the legend"});
  keys.choice("stage", &Curve::stages, {.doc = "the last stage, or a curve for each of all stages"});
  keys.real("density", &Curve::density,
            {.unit = "kg/m3", .range = exchange::above(0), .left_out = "the case's", .doc = "of eq-1"});
  keys.text("density_of", &Curve::density_of, {.doc = "eq-1 takes the mean density with which mpm ended this run"});
  return keys;
}

KeyTable<Figure> figure_keys() {
  KeyTable<Figure> keys("A figure of the report: profiles over the height.");
  keys.text("name", &Figure::name, {.required = true, .doc = "identifier"});
  keys.text("title", &Figure::title, {.doc = "above the figure"});
  keys.text("caption", &Figure::caption, {.doc = "below the figure"});
  keys.choice("quantity", &Figure::quantity, {.doc = "what is drawn over the height"});
  keys.table_array("curve", &Figure::curves, curve_keys());
  return keys;
}

KeyTable<Published> published_keys() {
  KeyTable<Published> keys("A published number, shown beside ours and the exact one.");
  keys.text("label", &Published::label, {.required = true, .doc = "what it is and where it is printed"});
  keys.real("value", &Published::value, {.unit = "SI", .required = true, .doc = "as published"});
  keys.text("run", &Published::run, {.required = true, .doc = "the run it is set beside"});
  keys.text("source", &Published::source, {.doc = "the solver, or the name of one of the case's references"});
  keys.choice("statistic", &Published::statistic, {.doc = "what is measured"});
  keys.text("why", &Published::why, {.doc = "a sentence that explains the difference"});
  return keys;
}

KeyTable<ReportOptions> report_keys() {
  KeyTable<ReportOptions> keys("What the report shows besides what is judged.");
  keys.boolean("fields", &ReportOptions::fields,
               {.doc =
                    "settlement and vertical stress as they lie in space at the end of construction; of a refinement "
                    "family those of its finest level"});
  return keys;
}

KeyTable<Campaign> campaign_keys() {
  KeyTable<Campaign> keys("A campaign: cases, what is varied over them, and what the report shows.");
  keys.integer("format", &Campaign::format,
               {.range = exchange::exactly(1), .required = true, .doc = "version of this format"});
  keys.text("title", &Campaign::title, {.doc = "title of the report"});
  keys.text("description", &Campaign::description, {.doc = "what the campaign shows, in a few sentences"});
  keys.texts("slurm_options", &Campaign::slurm_options,
             {.doc = "given to sbatch with every job of --executor slurm, such as \"--partition=short\""});
  keys.named_tables("solver", &Campaign::solvers, joined_solver_keys());
  keys.table_array("run", &Campaign::runs, run_keys());
  keys.table_array("figure", &Campaign::figures, figure_keys());
  keys.table_array("published", &Campaign::published, published_keys());
  keys.table("report", &Campaign::report, report_keys());
  return keys;
}

void check_solvers(const Campaign& campaign, const std::string& name, exchange::Reading& reading) {
  const std::vector<std::string> known = solver_names(campaign.solvers);
  for (std::size_t i = 0; i < campaign.runs.size(); ++i) {
    for (const std::string& solver : campaign.runs[i].solvers) {
      const std::string key = fmt::format("run.{}.solvers", i);
      const auto origin = reading.origins().find(key);
      const std::string where = origin != reading.origins().end() ? origin->second : name;
      if (const auto complaint = unknown_solver(solver, known, where, key)) reading.complain(*complaint);
    }
  }
}

/// `others`: solvers that the file may name without joining them itself.
Campaign campaign_of(const document::Table& table, const std::string& name, const JoinedSolvers& others) {
  exchange::Reading reading;
  Campaign campaign;
  campaign_keys().read(table, {.path = "", .where = name}, campaign, reading);
  settle_commands(name, campaign.solvers, reading);
  campaign.solvers.insert(others.begin(), others.end()); // the file's own go before those
  check_solvers(campaign, name, reading);
  if (campaign.runs.empty()) {
    reading.complain({.where = name,
                      .what = "the campaign has no run",
                      .given = {},
                      .allowed = "one [[run]] or more",
                      .remedy = "add [[run]] with a name and a case"});
  }
  reading.throw_if_any();
  campaign.file = name;
  return campaign;
}

/// A TOML value as it is, anything else as a text: a bare word will do on the command line.
std::string toml_of(const std::string& value) {
  try {
    document::parse_value(value, "--set");
    return value;
  } catch (const exchange::InputError&) {
    return document::to_inline_toml({value, {}});
  }
}

Figure profile_figure(const RunEntry& run, exchange::Quantity quantity, const std::string& title) {
  Figure figure{.name = std::string(exchange::name_of(quantity)),
                .title = title,
                .caption = {},
                .quantity = quantity,
                .curves = {}};
  const auto add = [&](const std::string& source, const std::string& label) {
    Curve curve;
    curve.run = run.name;
    curve.source = source;
    curve.label = label;
    figure.curves.push_back(curve);
  };
  for (const std::string& solver : run.solvers) {
    add(solver == "mpm" ? "exact" : "exact-" + solver, "exact, what " + solver + " solves");
    add(solver, solver);
  }
  if (quantity == exchange::Quantity::settlement) add("eq-1", "Eq. (1)");
  return figure;
}

RunEntry run_of_case(const std::filesystem::path& case_file, const std::vector<std::string>& overrides,
                     const std::vector<std::string>& solvers) {
  RunEntry run;
  run.name = case_file.stem().string();
  run.case_file = case_file.string();
  run.solvers = solvers;
  for (const std::string& override_text : overrides) {
    const std::size_t equals = override_text.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw exchange::InputError({.where = "--set",
                                  .what = "an override needs a key and a value",
                                  .given = override_text,
                                  .allowed = "key=value",
                                  .remedy = "for example --set construction.layers=10"});
    }
    run.set[override_text.substr(0, equals)] = toml_of(override_text.substr(equals + 1));
  }
  return run;
}

/// A campaign of one run, with the user's solvers. Throws InputError for a solver that is not known.
Campaign campaign_with(RunEntry run) {
  Campaign campaign;
  campaign.solvers = user_solvers();
  for (const std::string& solver : run.solvers) {
    const auto complaint = unknown_solver(solver, solver_names(campaign.solvers), "--solvers", "the command line");
    if (complaint) throw exchange::InputError(*complaint);
  }
  campaign.runs.push_back(std::move(run));
  return campaign;
}

/// The solvers whose convergence a case says something about; both where it says nothing.
std::vector<std::string> expected_solvers(const exchange::Case& study) {
  std::vector<std::string> solvers;
  for (const std::string solver : {"mpm", "fem"}) {
    if (!study.converge) continue;
    const auto& expected = study.converge->expectations;
    const bool named = std::any_of(expected.begin(), expected.end(),
                                   [&](const exchange::ExpectedConvergence& each) { return each.solver == solver; });
    if (named) solvers.push_back(solver);
  }
  return solvers.empty() ? std::vector<std::string>{"mpm", "fem"} : solvers;
}

} // namespace

Campaign read_campaign(const std::filesystem::path& file) {
  return campaign_of(document::read(file), file.string(), user_solvers());
}

Campaign parse_campaign(const std::string& text, const std::string& name) {
  return campaign_of(document::parse(text, name), name, {});
}

std::string to_toml(const Campaign& campaign) {
  return document::to_toml(campaign_keys().write(campaign));
}

std::string campaign_schema() {
  document::Table schema = campaign_keys().schema();
  schema.insert(schema.begin(), {"$schema", {}, {std::string("http://json-schema.org/draft-07/schema#"), {}}});
  return document::to_json({std::move(schema), {}});
}

Campaign campaign_of_case(const std::filesystem::path& case_file, const std::vector<std::string>& overrides,
                          const std::vector<std::string>& solvers) {
  Campaign campaign = campaign_with(run_of_case(case_file, overrides, solvers));
  const RunEntry& run = campaign.runs.front();
  campaign.title = run.name;
  campaign.figures = {profile_figure(run, exchange::Quantity::settlement, "Settlement since placement"),
                      profile_figure(run, exchange::Quantity::vertical_stress, "Vertical stress")};
  return campaign;
}

Campaign refinement_of_case(const std::filesystem::path& case_file, const std::vector<std::string>& overrides,
                            const std::vector<std::string>& solvers) {
  Campaign campaign = campaign_with(run_of_case(case_file, overrides, solvers));
  RunEntry& run = campaign.runs.front();
  run.converge = true;
  if (solvers.empty()) run.solvers = expected_solvers(exchange::read_case(case_file, overrides));
  campaign.title = run.name + " under refinement";
  return campaign;
}

} // namespace settle::compare
