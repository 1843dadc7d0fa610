/// \file
/// What somebody who waits for a campaign sees, on standard error.
#pragma once

#include "settle/compare/campaign_run.hpp"

namespace settle::compare::cli {

/// On a terminal one line that is written over, otherwise one line for each solver run that has ended. A failed solver
/// leaves its line in both.
class ProgressLine {
public:
  ProgressLine();
  void show(const Progress& progress);
  /// Removes the line on a terminal.
  void clear() const;

private:
  bool terminal_;
};

} // namespace settle::compare::cli
