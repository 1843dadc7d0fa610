/// \file
/// The case's known motion as it drives the body: the force on its points, and how its supports move.
#pragma once

#include <vector>

#include "settle/exchange/formulas.hpp"
#include "settle/mpm/body.hpp"

namespace settle::mpm {

/// Whether a scheme feels inertia by itself; one that does not has it taken off the body force.
enum class Inertia { felt, taken_off };

/// A nodal displacement that follows the motion.
struct FollowingNode {
  int dof = 0;              ///< dim * node + direction
  int direction = 0;        ///< 0: x, 1: y
  Vector<2> position{0, 0}; ///< of the node [m]
  int layer = 1;            ///< whose motion it follows
};

/// A stage runs from share 0 to share 1: of the gravity of its layer, or, where the motion has a duration, of time.
class Drive {
public:
  /// The case has a `[motion]` and outlives the drive.
  Drive(const exchange::Case& study, Inertia inertia, std::vector<FollowingNode> following);
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;
  ~Drive() = default;

  [[nodiscard]] bool runs_in_time() const { return study_.motion->duration.has_value(); }
  [[nodiscard]] double duration() const { return study_.motion->duration.value_or(0.0); } ///< [s]
  /// Gravity and body force at a moment of a stage; valid while the drive is.
  [[nodiscard]] Gravity gravity_at(int stage, double share) const;
  /// Displacements of the following nodes between two moments of a stage, by degree of freedom; zero for all others.
  /// Without a duration, supports move in proportion to the layer's gravity from the motion of the stage before to
  /// that of this one. Supports stand still in space, so the motion is taken at the node, not at a material point.
  [[nodiscard]] Eigen::VectorXd support_motion(int stage, double from, double to, Eigen::Index dofs) const;
  /// At t = 0 [m/s].
  [[nodiscard]] Vector<2> initial_velocity(const Points<2>& points, std::size_t p) const;

private:
  [[nodiscard]] double time_at(double share) const { return share * duration(); }
  [[nodiscard]] Vector<2> displacement_at(const FollowingNode& node, int stage, double share) const;

  const exchange::Case& study_;
  Inertia inertia_;
  exchange::Formulas formulas_;
  std::vector<FollowingNode> following_;
};

} // namespace settle::mpm
