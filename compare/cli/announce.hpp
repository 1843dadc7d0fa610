/// \file
/// Telling the service that runs `settle` how it ended.
#pragma once

#include "settle/compare/outcome.hpp"

namespace settle::compare::cli {

/// Is this a job of GitHub Actions, or a test of CTest?
bool somebody_listens();

/// GitHub Actions (GITHUB_ACTIONS is "true"): annotations on standard output, and the summary at the end of the file
/// that GITHUB_STEP_SUMMARY names. CTest: measurements on standard output. Throws FileError where that file cannot be
/// written.
void announce(const CampaignOutcome& outcome);

} // namespace settle::compare::cli
