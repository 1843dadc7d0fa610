/// \file
/// The parts of the page, in its order. Each returns HTML.
#pragma once

#include <string>
#include <vector>

#include "html_table.hpp"
#include "settle/compare/outcome.hpp"

namespace settle::compare::report {

struct Plot;
struct CaseEntry;
struct Facets;

/// The address of a run's section: unique in the page.
std::string anchor_of(const CampaignOutcome& outcome, const RunOutcome& run);

/// The same of a refinement family's section.
std::string anchor_of(const CampaignOutcome& outcome, const Family& family);

/// Verdicts, a line each in their order, marked for the script's filters.
Table verdict_table(const std::vector<Verdict>& verdicts, const Facets& facets);
/// All verdicts that did not pass, with their cases; empty where all passed.
std::string problems_html(const CampaignOutcome& outcome, const Facets& facets);
/// A line a case: verdict, the tightest margin, key figures, time.
std::string index_html(const CampaignOutcome& outcome, const std::vector<CaseEntry>& cases);
/// "✗ 2 of 3": the worst verdict of a case's leg, and how many passed of all.
Cell matrix_cell(const CaseEntry& entry, const std::string& leg);
/// A line a case, a column a leg: the worst verdict, and how many passed of all.
std::string matrix_html(const std::vector<CaseEntry>& cases, const Facets& facets);
/// What the refinement families show: figures, levels, conclusions, verdicts; empty where the campaign has none.
std::string families_html(const CampaignOutcome& outcome, const Facets& facets);
/// A figure with its caption.
std::string figure_html(const Plot& plot, const std::string& caption);
/// A drawing with title and caption; a sentence for each curve that is not in it.
struct Drawing {
  std::string id, title, caption;
  std::string script; ///< gnuplot's; empty: there is nothing to draw
  std::vector<std::string> missing;
};
std::string figure_html(const Drawing& drawing);
/// Settlement and vertical stress at the end of construction as they lie in space, of every solver of a run.
std::string fields_html(const CampaignOutcome& outcome, const RunOutcome& run);
/// What is exact of a run, typeset; a link where an earlier run has shown the same.
std::string formulas_html(const CampaignOutcome& outcome, const RunOutcome& run);
/// The largest settlement after each stage, drawn and in numbers; empty for a single stage.
std::string history_html(const CampaignOutcome& outcome, const RunOutcome& run);
/// The published numbers beside ours; empty where the campaign has none.
std::string published_html(const CampaignOutcome& outcome);
/// One run's section.
/// `open`: unfolded from the start.
std::string run_html(const CampaignOutcome& outcome, const RunOutcome& run, const Facets& facets, bool open);

/// Tables of a run's section.
Table solver_table(const RunOutcome& run);
Table key_figure_table(const RunOutcome& run);
/// The parts of one difference between MPM and FEM, the largest marked.
Table split_table(const DifferenceSplit& split, int dimension);
/// How each of those parts is computed.
Table parts_table();
/// Of every solver with a result.
Table balance_table(const RunOutcome& run);
/// Of every solver whose body failed: the height in equilibrium last, beside the exact one where a check states it.
Table onset_table(const RunOutcome& run);
/// Of every solver that went on after failure, with what has become of the work of gravity.
Table run_out_table(const RunOutcome& run);
Table refill_table(const exchange::Result& result);
Table parameter_table(const RunOutcome& run);
/// What the keys in the parameter tables of all runs mean, each once.
Table glossary_table(const CampaignOutcome& outcome);
Table provenance_table(const RunOutcome& run);

/// A sentence for each solver whose base reaction is not held against its weight: why.
std::vector<std::string> unaudited_reactions(const RunOutcome& run);

/// A sentence for each solver that ended a stage out of equilibrium, or was told not to wait for it.
std::vector<std::string> out_of_equilibrium(const RunOutcome& run);

} // namespace settle::compare::report
