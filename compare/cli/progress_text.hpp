/// \file
/// The plan and the progress of a campaign in words.
#pragma once

#include <cstddef>
#include <string>

#include "settle/compare/campaign_plan.hpp"
#include "settle/compare/campaign_progress.hpp"

namespace settle::compare::cli {

/// "12 s", "3 min 20 s", "2 h 5 min".
std::string time_text(double seconds);

/// "[3/20] RUN, SOLVER: finished, 1.23 s".
std::string ended_line(const Progress& progress);

/// "[#####---------------] 5/20, 3 min 20 s left: RUN, SOLVER; RUN, SOLVER", cut to a width.
std::string progress_line(const Progress& progress, std::size_t width);

/// A line a task that would be run, in order, with the reason; then how many would be and how many are up to date.
std::string plan_text(const Plan& plan);

} // namespace settle::compare::cli
