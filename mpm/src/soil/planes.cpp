#include "settle/mpm/soil/planes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>

#include <Eigen/LU>

namespace settle::mpm::soil {

namespace {

/// By how much a plane may be passed, or a flow be negative, relative to the stresses at hand: round-off.
constexpr double round_off = 1e-12;

/// Below this ratio of pivots planes or flows depend on each other.
constexpr double dependent = 1e-12;

/// Up to three planes side by side.
using Few = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;
using FewNumbers = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 3, 1>;

/// An attempt to end on some of the planes.
struct Attempt {
  Returned end;
  double wrong = std::numeric_limits<double>::infinity(); ///< worst passing or negative flow [Pa]
};

class Search {
public:
  Search(const Lame& lame, std::span<const Plane> planes, const Values& trial)
      : planes_(planes), trial_(trial), stiffness_(principal_stiffness(lame)), mu_(lame.mu) {}

  /// Ends on the planes whose bits are set.
  [[nodiscard]] Attempt end_on(unsigned chosen) const {
    const int n = std::popcount(chosen);
    Few normal(3, n), flow(3, n);
    FewNumbers passed(n);
    int k = 0;
    for (std::size_t i = 0; i < planes_.size(); ++i)
      if (is_in(chosen, i)) {
        normal.col(k) = planes_[i].normal, flow.col(k) = planes_[i].flow;
        passed[k++] = planes_[i].normal.dot(trial_) - planes_[i].limit;
      }
    const Few pull = stiffness_ * flow;
    Eigen::FullPivLU<Few> system(normal.transpose() * pull);
    system.setThreshold(dependent);
    Attempt attempt;
    if (!system.isInvertible()) return attempt;
    const FewNumbers amount = system.solve(passed);
    const Values& end = attempt.end.stress = trial_ - pull * amount;
    attempt.end.by_trial = ByValues::Identity() - pull * system.solve(Few(normal.transpose()));
    attempt.wrong = std::max({most_passed(end), out_of_order(end), -2.0 * mu_ * amount.minCoeff()});
    return attempt;
  }

  /// How far the worst plane is passed [Pa]; negative inside all.
  [[nodiscard]] double most_passed(const Values& stress) const {
    double most = -std::numeric_limits<double>::infinity();
    for (const Plane& plane : planes_)
      most = std::max(most, plane.normal.dot(stress) - plane.limit);
    return most;
  }
  /// By how much a value is larger than the one before it [Pa].
  [[nodiscard]] static double out_of_order(const Values& stress) {
    return std::max(stress[1] - stress[0], stress[2] - stress[1]);
  }

private:
  std::span<const Plane> planes_;
  Values trial_;
  Eigen::Matrix3d stiffness_;
  double mu_;

  [[nodiscard]] static bool is_in(unsigned chosen, std::size_t plane) { return (chosen >> plane & 1U) != 0; }
};

} // namespace

std::optional<Returned> return_to_planes(const Lame& lame, std::span<const Plane> planes,
                                         const std::optional<Values>& apex, const Values& trial) {
  const Search search(lame, planes, trial);
  if (search.most_passed(trial) <= 0.0) return std::nullopt;
  const double allowed = round_off * trial.cwiseAbs().maxCoeff();
  Attempt best;
  for (int size = 1; size <= 3; ++size)
    for (unsigned chosen = 1; chosen < 1U << planes.size(); ++chosen) {
      if (std::popcount(chosen) != size) continue;
      const Attempt attempt = search.end_on(chosen);
      if (attempt.wrong <= allowed) return attempt.end;
      if (attempt.wrong < best.wrong) best = attempt;
    }
  if (apex && search.most_passed(*apex) <= allowed) return Returned{.stress = *apex};
  return best.end;
}

} // namespace settle::mpm::soil
