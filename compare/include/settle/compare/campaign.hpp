/// \file
/// The campaign file: runs (cases with a matrix of overrides), the figures and the published numbers its report shows.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "settle/compare/joined_solver.hpp"
#include "settle/exchange/case.hpp"

namespace settle::compare {

/// One entry `[[run]]`: a case, what is set for all of it, and what is varied.
struct RunEntry {
  std::string name; ///< unique after expansion; `{construction.layers}` stands for the value of a key of matrix or zip
  std::string case_file; ///< relative to the campaign file
  std::vector<std::string> solvers{"mpm", "fem"};
  std::map<std::string, std::string> set;                 ///< dotted key -> TOML value
  std::map<std::string, std::vector<std::string>> matrix; ///< dotted key -> TOML values; the product of all keys is run
  std::map<std::string, std::vector<std::string>> zip;    ///< the same, but run in step: all lists are of one length
  bool converge = false;              ///< run the levels of the case's `[converge]`, as one refinement family
  double time_limit = 600.0;          ///< wall time of one solver [s]
  std::optional<double> memory_limit; ///< of one solver [B]; nothing: nine tenths of the machine's
  std::string note;                   ///< shown in the report: what this run is for, what is known to differ
};

/// A curve of a figure.
struct Curve {
  std::string run; ///< name of an expanded run
  std::string
      source; ///< a solver, "exact" (of what mpm solves), "exact-SOLVER" (of what it solves), "eq-1", or a reference
  std::string label;
  exchange::CheckStages stages = exchange::CheckStages::last;
  std::optional<double> density; ///< "eq-1" only [kg/m3]; left out: the case's
  std::string density_of;        ///< "eq-1" only: the mean density this run's MPM result ended with
};

/// A figure of the report: a profile over the height of the construction.
struct Figure {
  std::string name; ///< identifier, also the SVG's
  std::string title;
  std::string caption;
  exchange::Quantity quantity = exchange::Quantity::settlement;
  std::vector<Curve> curves;
};

/// What a number in the table of published values measures.
enum class Statistic { max_settlement, max_vertical_stress, mean_density, base_reaction_stress, refilled_points };

/// A number somebody printed, to be shown beside ours and the exact one.
struct Published {
  std::string label;
  double value = 0; ///< SI
  std::string run;  ///< the run it is set beside
  std::string source = "mpm";
  Statistic statistic = Statistic::max_settlement;
  std::string why; ///< the sentence that explains the difference
};

/// What the report shows besides what is judged.
struct ReportOptions {
  bool fields = true; ///< field pictures, of a refinement family those of its finest level
};

struct Campaign {
  int format = 1;
  std::string title;
  std::string description;
  std::vector<std::string> slurm_options; ///< given to sbatch with every job of `--executor slurm`
  JoinedSolvers solvers;                  ///< besides mpm and fem; with those of the user's file once read from a file
  std::vector<RunEntry> runs;
  std::vector<Figure> figures;
  std::vector<Published> published;
  ReportOptions report;
  std::filesystem::path file;
};

} // namespace settle::compare

namespace settle::exchange {
template <>
struct EnumNames<compare::Statistic> {
  static constexpr std::array<std::string_view, 5> names{"max-settlement", "max-vertical-stress", "mean-density",
                                                         "base-reaction-stress", "refilled-points"};
};
} // namespace settle::exchange
