#include "settle/mpm/drive.hpp"

#include <algorithm>

namespace settle::mpm {
namespace {

Vector<2> vector_of(const std::array<double, 2>& components) {
  return {components[0], components[1]};
}

exchange::FormulaPoint point_of(const Points<2>& points, std::size_t p, int stage, double time) {
  return {.x = points.placed[0][p], .y = points.placed[1][p], .time = time, .layer = points.layer[p], .stage = stage};
}

} // namespace

Drive::Drive(const exchange::Case& study, Inertia inertia, std::vector<FollowingNode> following)
    : study_(study), inertia_(inertia), formulas_(study), following_(std::move(following)) {}

Gravity Drive::gravity_at(int stage, double share) const {
  const double factor = runs_in_time() ? 1.0 : share;
  const double time = time_at(share);
  Gravity gravity{.acceleration = study_.gravity, .ramped_layer = stage, .factor = factor};
  const bool inertia_taken_off = runs_in_time() && inertia_ == Inertia::taken_off;
  gravity.besides = [this, stage, factor, time, inertia_taken_off](const Points<2>& points, std::size_t p) {
    const exchange::FormulaPoint at = point_of(points, p, stage, time);
    Vector<2> force = vector_of(formulas_.body_force(at));
    if (points.layer[p] == stage) force *= factor;
    if (inertia_taken_off) force -= vector_of(formulas_.acceleration(at));
    return force;
  };
  return gravity;
}

Vector<2> Drive::displacement_at(const FollowingNode& node, int stage, double share) const {
  exchange::FormulaPoint at{.x = node.position[0],
                            .y = node.position[1],
                            .time = time_at(share),
                            .layer = std::min(node.layer, stage),
                            .stage = stage};
  if (runs_in_time()) return vector_of(formulas_.displacement(at));
  const Vector<2> end = vector_of(formulas_.displacement(at));
  Vector<2> start = Vector<2>::Zero(); // of a layer that has just been placed
  at.stage = stage - 1;
  if (at.layer < stage) start = vector_of(formulas_.displacement(at));
  return start + share * (end - start);
}

Eigen::VectorXd Drive::support_motion(int stage, double from, double to, Eigen::Index dofs) const {
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(dofs);
  for (const FollowingNode& node : following_)
    motion[node.dof] = (displacement_at(node, stage, to) - displacement_at(node, stage, from))[node.direction];
  return motion;
}

Vector<2> Drive::initial_velocity(const Points<2>& points, std::size_t p) const {
  return vector_of(formulas_.velocity(point_of(points, p, 1, 0.0)));
}

} // namespace settle::mpm
