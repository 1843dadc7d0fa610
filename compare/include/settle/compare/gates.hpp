/// \file
/// The verdicts in the forms in which machines that guard a project read them (docs/ci).
#pragma once

#include <filesystem>
#include <string>

#include "settle/compare/outcome.hpp"

namespace settle::compare {

/// Workflow commands of GitHub Actions: "::error file=...,line=...::..." for every verdict that is not passed, at its
/// check in the case. Files below `root` are named relative to it.
std::string github_annotations(const CampaignOutcome& outcome, const std::filesystem::path& root);

/// GitLab's code quality report (JSON): an issue for every verdict that is not passed. Its fingerprint is that of run
/// and comparison, not of the value, so that GitLab knows it again.
std::string gitlab_code_quality(const CampaignOutcome& outcome);

/// "<CTestMeasurement ...>" for the value of every check and convergence verdict that has one: CTest takes them from a
/// test's output, and CDash draws them over time.
std::string ctest_measurements(const CampaignOutcome& outcome);

} // namespace settle::compare
