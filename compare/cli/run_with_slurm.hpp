/// \file
/// A campaign by Slurm: submitted, followed, shown.
#pragma once

#include <string>

#include "run_and_report.hpp"
#include "settle/compare/slurm_campaign.hpp"

namespace settle::compare::cli {

/// Submits what is due, unless an earlier call has done so already, follows it to its end, and shows that.
exchange::ExitCode run_with_slurm(Campaign campaign, const RunningOptions& options, SlurmOptions slurm,
                                  const std::string& command_line);

} // namespace settle::compare::cli
