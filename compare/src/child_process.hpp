/// \file
/// A child as the operating system sees it: started, waited for, killed with its group.
#pragma once

#include <chrono>

#include <sys/types.h>

#include "settle/compare/process.hpp"

namespace settle::compare {

/// A started program, leader of a process group of its own. The kernel kills it when the thread that started it ends.
/// Destroying a child that has not been reaped kills and reaps it.
class Child {
public:
  /// `problem()` says why where it could not be started.
  explicit Child(const ProcessRequest& request);
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] pid_t id() const { return id_; }
  /// Waits for its end, at most so long. True: it has ended, and can be reaped.
  [[nodiscard]] bool wait(std::chrono::milliseconds most);
  /// Kills the whole group.
  void kill_group() const;
  /// Kills what is left of the group of a child that has ended, and fills in how it ended and what it has used.
  void reap(ProcessOutcome& outcome);

private:
  void start(const ProcessRequest& request);
  [[nodiscard]] bool has_ended_within(std::chrono::milliseconds most) const;

  pid_t id_ = -1;
  int handle_ = -1;          ///< that becomes readable when the child ends; -1 on kernels without
  double seen_peak_ = 0;     ///< of its memory, while it was waited for [B]
  double starters_peak_ = 0; ///< of this program's memory when it was started [B]
  std::string problem_;
};

} // namespace settle::compare
