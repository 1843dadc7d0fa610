/// \file
/// A verdict: never a bool. Only "passed" is green; what is missing or could not be judged is not.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace settle::compare {

enum class Status {
  passed,  ///< judged, within its limits
  failed,  ///< judged, outside its limits
  missing, ///< there is nothing to judge: no result, no such field, no points, a NaN
  error    ///< the judging itself, or the solver, broke
};

/// "passed", "failed", "missing", "error".
std::string_view name_of(Status status);

/// One judged comparison or audit.
struct Verdict {
  Status status = Status::missing;
  std::string run{};  ///< the name of the run or family in its campaign
  std::string what{}; ///< "settlement, mpm - exact, l2 over points, last stage"
  std::string kind{}; ///< "check" (the case's own), "audit" (conservation), "physics" (solver used what the case says),
                      ///< "solver" (did it finish), "convergence" (of a refinement family)
  double value = std::numeric_limits<double>::quiet_NaN(); ///< measured, relative to `scale`
  double at_least = 0;                                     ///< lower end of the accepted band
  double limit = 0;                                        ///< upper end of the accepted band
  std::string scale{};    ///< what the value is relative to, with its unit, e.g. "l2 norm of the reference: 0.18 m"
  std::string why{};      ///< the reason for the limit
  std::string where{};    ///< `file:line:column` of the check or expectation in its case, or the case file
  std::string message{};  ///< what happened, in a sentence, where the status is not "passed"
  std::string quantity{}; ///< what is compared or conserved: "settlement", "mass"; empty for what concerns a whole run
  std::string leg{};      ///< whose: "mpm - exact", or "mpm" where it is about one solver alone; empty for neither

  explicit operator bool() const = delete;
};

/// The worst of many: error, missing, failed, passed; missing where there are none at all.
Status worst(const std::vector<Verdict>& verdicts);

} // namespace settle::compare
