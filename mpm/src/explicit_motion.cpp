#include <algorithm>
#include <cmath>

#include "settle/mpm/explicit_step.hpp"
#include "settle/mpm/loading.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {
namespace {

template <class Space>
void start(const Drive& drive, Body<Space>& body) {
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const Vector<2> velocity = drive.initial_velocity(body.points, p);
    for (std::size_t d = 0; d < 2; ++d)
      body.points.velocity[d][p] = velocity[static_cast<int>(d)];
  }
}

} // namespace

template <class Space>
StageReport run_motion(Body<Space>& body, const StageLoad& load, double courant) {
  const Drive& drive = *load.drive;
  Nodes<Space::dim> nodes(static_cast<std::size_t>(body.space.n_nodes()));
  StageReport report;
  start(drive, body);
  double time = 0, last_step = 0;
  while (time < drive.duration()) {
    const double left = drive.duration() - time;
    const double dt = left / std::ceil(left / stable_time_step(body, courant));
    const Gravity gravity = drive.gravity_at(load.layer, time / drive.duration());
    scatter_points(body, gravity, nodes);
    const ForceSums sums = update_nodes(body, 0.0, nodes);
    update_velocity_and_remap(body, 0.5 * (last_step + dt), nodes);
    update_stress_and_move(body, {.acceleration = 0.0}, dt, nodes); // the work done is of no interest
    time += dt;
    last_step = dt;
    ++report.steps;
    report.base_reaction = sums.base_reaction;
    report.out_of_balance = sums.external > 0 ? sums.unbalanced / sums.external : 0.0;
    if (left <= dt) break; // the last step: what is left of the time is round-off
  }
  return report;
}

#define SETTLE_INSTANTIATE(Space) template StageReport run_motion(Body<Space>&, const StageLoad&, double);
SETTLE_FOR_EVERY_PLANE_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
