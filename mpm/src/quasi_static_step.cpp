#include "settle/mpm/quasi_static_step.hpp"

#include <algorithm>
#include <cmath>

#include "quasi_static_system.hpp"
#include "settle/mpm/nodal_forces.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

constexpr int max_iterations = 25;

/// How exactly the next linear system is solved, relative to its right side: with a tenth of the residual, a share
/// of the load, Newton's iteration stays quadratic (Dembo, Eisenstat & Steihaug 1982).
double linear_tolerance(double residual) {
  return std::clamp(0.1 * residual, 1e-13, 0.01);
}

} // namespace

template <class Space>
QuasiStaticStep<Space>::QuasiStaticStep(double tolerance, exchange::MpmLinearSolver solver, Threads threads)
    : system_(std::make_unique<QuasiStaticSystem<Space>>(solver, threads)), tolerance_(tolerance) {}
template <class Space>
QuasiStaticStep<Space>::QuasiStaticStep(QuasiStaticStep&&) noexcept = default;
template <class Space>
QuasiStaticStep<Space>::~QuasiStaticStep() = default;

template <class Space>
IncrementReport QuasiStaticStep<Space>::advance(Body<Space>& body, const Gravity& gravity, double fraction,
                                                const Eigen::VectorXd& support_motion) {
  QuasiStaticSystem<Space>& system = *system_;
  system.renumber(body);
  const Eigen::VectorXd external = external_forces(body, gravity);
  double scale = external.norm();
  Eigen::VectorXd internal(external.size()), displacement = Eigen::VectorXd::Zero(external.size()), target, step;

  IncrementReport report;
  for (int iteration = 0; iteration <= max_iterations; ++iteration) {
    if (!system.assemble(body, displacement, internal)) return report;
    if (iteration == 0) {
      target = internal + fraction * (external - internal);
      if (support_motion.size() > 0) displacement = support_motion;
      if (support_motion.size() > 0 && !system.assemble(body, displacement, internal)) return report;
      scale = std::max(scale, internal.norm()); // moved supports load as much as weight does
    }
    const Eigen::VectorXd residual = system.free_part(target - internal);
    report.residuals.push_back(scale > 0.0 ? residual.norm() / scale : 0.0);
    report.out_of_balance = report.residuals.back();
    report.converged = report.out_of_balance <= tolerance_;
    if (report.converged || iteration == max_iterations || !std::isfinite(report.out_of_balance)) break;
    ++report.linear_solves;
    const double accuracy = linear_tolerance(report.out_of_balance);
    if (!system.solve(residual, accuracy, step)) return report;
    system.add_to_free(step, displacement);
  }
  if (!report.converged) return report;
  report.base_reaction = base_reaction(body, internal, external);
  report.reactions = support_forces(body, internal, external);
  report.largest_displacement = displacement.template lpNorm<Eigen::Infinity>();
  system.move_points(body, displacement);
  body.sort();
  if (body.average_stress) replace_stress_by_cell_average(body);
  return report;
}

#define SETTLE_INSTANTIATE(Space) template class QuasiStaticStep<Space>;
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
