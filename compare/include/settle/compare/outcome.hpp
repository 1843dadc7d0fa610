/// \file
/// What came out of a campaign: everything a report shows, and nothing it has to compute from files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "settle/compare/campaign.hpp"
#include "settle/compare/family.hpp"
#include "settle/compare/verdict.hpp"
#include "settle/exchange/result.hpp"

namespace settle::compare {

/// How a solver's process ended.
enum class SolverStatus {
  finished,
  bad_input,
  not_converged,
  file_failed,
  crashed,
  timed_out,
  no_result,
  bad_result,
  not_found,
  out_of_memory, ///< it took more memory than its run may
  wrong_version, ///< its result has a version this build does not read
  disk_full,
  no_folder ///< the folder of its run cannot be written
};

/// "finished", "bad input", ...
std::string_view name_of(SolverStatus status);
/// The status of a name; nothing for a name that none has.
std::optional<SolverStatus> status_named(std::string_view name);

/// One solver's part of a run.
struct SolverRun {
  std::string solver{}; ///< "mpm", "fem", or a joined one
  std::string title{};  ///< of a joined one; see `title_of`
  SolverStatus status = SolverStatus::no_result;
  std::string command{}; ///< as one can type it
  int exit_code = 0;
  std::string message{};  ///< one sentence where the status is not "finished"
  std::string tail{};     ///< the last lines of the solver's output
  double wall_time = 0;   ///< of the process [s]
  double cpu_time = 0;    ///< of the process and its children [s]
  double peak_memory = 0; ///< largest resident set [B]
  bool reused = false;    ///< an up-to-date result was already there
  std::filesystem::path result_file{};
  std::optional<exchange::Kinematics> kinematics{}; ///< what a joined solver is said to solve
  std::optional<exchange::Result> result{};
};

/// What reports call a solver: "MPM", "FEM", its title, or its name.
std::string title_of(const SolverRun& solver);

/// Where an MPM - FEM difference comes from: it is the sum of three parts at every probe, and some of what makes up the
/// parts is known. Norms over probes, relative to the same norm of the exact solution of what FEM solves; NaN: not
/// known.
struct DifferenceSplit {
  exchange::Quantity quantity = exchange::Quantity::settlement;
  double total = 0;            ///< MPM - FEM
  double mpm_error = 0;        ///< MPM - exact_mpm
  double model_difference = 0; ///< exact_mpm - exact_fem
  double fem_error = 0;        ///< exact_fem - FEM
  double scale = 0;            ///< what they are relative to [SI unit of the quantity]
  double mpm_mass = 0;         ///< in mpm_error: the mass that MPM has too much or too little
  double mpm_unbalanced = 0;   ///< in mpm_error: the force that MPM left unbalanced
  double fem_unbalanced = 0;   ///< in fem_error: the force that FEM left unbalanced
  double layers = 0;           ///< in model_difference: what the finite number of layers changes in it
  double mpm_layers = 0;       ///< in exact_mpm: what the finite number of layers changes in it
  double fem_layers = 0;       ///< in exact_fem: likewise
};

/// A table of another code's results, averaged over points at one height. Same conventions as SamplePoints; one vector
/// entry a row.
struct ReferenceTable {
  std::string title;
  std::string file;
  std::vector<int> stage, layer, points;               ///< stage, layer, how many points the row averages
  std::vector<double> placed_height, settlement;       ///< [m]
  std::vector<double> vertical_stress, lateral_stress; ///< tension positive [Pa]
  std::vector<double> density;                         ///< mass over volume of the row's points [kg/m3]
  std::vector<double> volume;                          ///< of all the row's points [m3/m]

  [[nodiscard]] std::size_t size() const { return stage.size(); }
};

/// One expanded run: a case, its solvers, what was judged.
struct RunOutcome {
  std::string name{};
  std::string note{};
  std::string family{}; ///< of which refinement family the run is a level; empty: of none
  exchange::Case study{};
  std::vector<std::string> overrides{};          ///< `key=value`
  std::string case_file{};                       ///< as the user named it, even where `study` is a copy of it
  std::vector<std::string> check_places{};       ///< of each check of the case: `file:line:column` in that file
  std::vector<std::string> expectation_places{}; ///< the same of each `[[converge.expect]]`
  std::vector<SolverRun> solvers{};
  std::map<std::string, ReferenceTable> references{};
  std::vector<DifferenceSplit> splits{};
  std::vector<Verdict> verdicts{};

  /// The result of a solver, or nullptr.
  [[nodiscard]] const exchange::Result* result_of(const std::string& solver) const;
};

/// A whole campaign.
struct CampaignOutcome {
  Campaign campaign;
  std::string command{}; ///< that runs it again
  std::string created{}; ///< UTC, ISO 8601
  std::string program_version{}, commit{};
  double wall_time = 0; ///< [s]
  std::vector<RunOutcome> runs{};
  std::vector<Family> families{}; ///< refinement families among the runs

  [[nodiscard]] const RunOutcome* find(const std::string& run) const;
  /// The solvers of all runs besides mpm and fem, one of each name.
  [[nodiscard]] std::vector<const SolverRun*> joined_solvers() const;
};

} // namespace settle::compare
