/// \file
/// Where the files of a campaign lie: DIR/runs/RUN/{case.toml, SOLVER.h5, SOLVER.log, SOLVER.key (its record),
/// REFERENCE.csv}.
#pragma once

#include <filesystem>
#include <string>

#include "settle/compare/expand.hpp"

namespace settle::compare {

/// The folder of a run.
std::filesystem::path run_folder(const std::filesystem::path& campaign_folder, const std::string& run);

/// The result of a solver.
std::filesystem::path result_in(const std::filesystem::path& run_folder, const std::string& solver);

/// The case of a run as joined solvers get it: overrides applied, defaults filled in.
std::filesystem::path case_in(const std::filesystem::path& run_folder);

/// Creates the folder of a run with its case, defaults filled in, and copies of the reference tables, so that it can be
/// judged again wherever it is. What is there already is not written again; unfinished files are removed. Throws
/// FileError where it cannot be written.
void prepare_run_folder(const std::filesystem::path& folder, const ExpandedRun& run);

/// Does the folder of a run hold its case as it is?
bool is_prepared(const std::filesystem::path& folder, const ExpandedRun& run);

/// Is there next to no space (1 MiB) left on the disk of a folder, or where it would be?
bool is_full(const std::filesystem::path& folder);

/// The case of a run's folder. Throws FileError where it is missing.
exchange::Case stored_case(const std::filesystem::path& folder);

} // namespace settle::compare
