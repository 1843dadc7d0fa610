/// \file
/// One solver run of a campaign by itself: what another program that starts runs needs.
#pragma once

#include <filesystem>
#include <string>

#include "run_and_report.hpp"

namespace settle::compare::cli {

/// Runs the task of this title, "RUN, SOLVER", where it is due, writes its result and record, and judges nothing.
/// Several may be at work in one folder.
exchange::ExitCode run_single(Campaign campaign, const RunningOptions& options, const std::filesystem::path& folder,
                              const std::string& title);

} // namespace settle::compare::cli
