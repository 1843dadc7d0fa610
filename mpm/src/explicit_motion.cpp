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
StageReport run_motion(Body<Space>& body, const StageLoad& load, double courant, int threads) {
  const Drive& drive = *load.drive;
  StageReport report;
  start(drive, body);
  ExplicitStep<Space> step(body, threads);
  double time = 0, last_step = 0;
  while (time < drive.duration()) {
    const double left = drive.duration() - time;
    step.scatter(drive.gravity_at(load.layer, time / drive.duration()));
    const double dt = left / std::ceil(left / step.stable_time_step(courant));
    const ForceSums sums = step.accelerate(0.0);
    step.displace(0.5 * (last_step + dt), dt);
    step.move();
    time += dt;
    last_step = dt;
    ++report.steps;
    report.base_reaction = sums.base_reaction;
    report.out_of_balance = sums.external > 0 ? sums.unbalanced / sums.external : 0.0;
    if (left <= dt) break; // the last step: what is left of the time is round-off
  }
  step.gather();
  return report;
}

#define SETTLE_INSTANTIATE(Space) template StageReport run_motion(Body<Space>&, const StageLoad&, double, int);
SETTLE_FOR_EVERY_PLANE_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
