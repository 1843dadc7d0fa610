/// \file
/// From the entries of a campaign to single runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "settle/compare/campaign.hpp"
#include "settle/exchange/case.hpp"

namespace settle::compare {

/// One case with its overrides, ready to be given to solvers.
struct ExpandedRun {
  std::string name;
  std::string note;
  std::string family; ///< the entry's name where the run is a level of a refinement family, else empty
  std::filesystem::path case_file;
  std::vector<std::string> overrides; ///< `key=value`
  std::vector<std::string> solvers;
  JoinedSolvers joined;               ///< those of them that a file joins
  double time_limit = 600.0;          ///< [s]
  std::optional<double> memory_limit; ///< [B]; nothing: nine tenths of the machine's
  exchange::Case study;               ///< read with the overrides
};

/// Every run of a campaign, in the file's order, the last key of a matrix varying fastest, the lists of a zip, which
/// run in step, before them. Throws InputError for a case that cannot be read, for levels that do not become finer, for
/// runs that would have one name or folder, for a placeholder that is no key of the matrix, and for figures or
/// published numbers that name a run or a source there is not.
std::vector<ExpandedRun> expand(const Campaign& campaign);

/// A run's name as a file name: everything but letters, digits, ".", "_", "-" becomes "_".
std::string folder_name(const std::string& run);

} // namespace settle::compare
