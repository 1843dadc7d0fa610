/// \file
/// A root to round-off.
#pragma once

#include <cmath>

namespace settle::fem {

struct ValueAndSlope {
  double value;
  double slope;
};

/// Where `f` (argument to ValueAndSlope) is zero between `above`, where it is positive or zero, and `below`, where it
/// is negative or zero, in either order; by Newton's method from `start`, in halves where that leaves the bracket or
/// falls behind. Ends where the argument no longer changes.
template <class F>
double bracketed_root(const F& f, double above, double below, double start) {
  constexpr int steps_allowed = 200; // halves alone need about 60 from a bracket of the size of the root
  double x = start, last_step = std::abs(below - above);
  for (int step = 0; step < steps_allowed; ++step) {
    const ValueAndSlope at = f(x);
    if (at.value == 0.0) return x;
    (at.value > 0.0 ? above : below) = x;
    double next = x - at.value / at.slope;
    const bool inside = (next - above) * (next - below) <= 0.0;
    if (!inside || 2.0 * std::abs(next - x) > last_step) next = (above + below) / 2.0;
    if (next == x || next == above || next == below) return next;
    last_step = std::abs(next - x);
    x = next;
  }
  return x;
}

} // namespace settle::fem
