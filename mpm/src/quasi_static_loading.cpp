#include <algorithm>

#include <fmt/ranges.h>

#include "settle/exchange/errors.hpp"
#include "settle/mpm/loading.hpp"
#include "settle/mpm/quasi_static_step.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

constexpr double smallest_fraction = 1.0 / 64.0;
constexpr int max_closing_increments = 200;

/// `carried`: share of the increment that found its equilibrium.
[[noreturn]] void give_up(const StageLoad& load, const Gravity& gravity, const IncrementReport& report,
                          double carried) {
  throw exchange::NotConverged(
      {.where = fmt::format("stage {}, gravity factor {:g} of layer {}", load.number, gravity.factor, load.layer),
       .what = fmt::format("the quasi-static increment did not converge, even in 64 parts; {:.3f} of it is carried",
                           carried),
       .given = fmt::format("relative out-of-balance force by iteration: {:.2e}", fmt::join(report.residuals, ", ")),
       .allowed = "mpm.quasi_static.residual",
       .remedy = "where a soil fails there is no equilibrium: mpm.scheme = \"explicit\" goes on; else take more "
                 "mpm.quasi_static.increments, or smaller elements"});
}

/// Whether a node that `support_motion` moves belongs to a cell with points in it.
template <class Space>
bool is_touched(const Body<Space>& body, const Eigen::VectorXd& support_motion) {
  for (const int cell : body.cells.occupied) {
    const auto stencil = body.space.cell_average(cell);
    for (int i = 0; i < stencil.size(); ++i)
      if (support_motion.segment<Space::dim>(Space::dim * stencil.node(i)).any()) return true;
  }
  return false;
}

/// Supports stand still in space while what they push moves away: without this check the body would spring back.
template <class Space>
void require_touched(const Body<Space>& body, const StageLoad& load, const Eigen::VectorXd& support_motion) {
  if (!support_motion.any() || is_touched(body, support_motion)) return;
  throw exchange::NotConverged(
      {.where = fmt::format("stage {}", load.number),
       .what = "the supports that move have lost the body: no element at their nodes has a point left in it",
       .given = fmt::format("a motion of up to {:g} m to go, elements of {:g} m",
                            support_motion.lpNorm<Eigen::Infinity>(), body.space.size()),
       .allowed = "motions that leave points in the elements next to the support, as supports stand still in space",
       .remedy = "take larger elements (mpm.element_size) or a smaller motion"});
}

/// Balances a share of what is out of balance at this gravity, in halved parts where Newton fails on the whole, while
/// supports move by `support_motion`. Returns how much of that share could be balanced: 1, or less where the stage may
/// fail.
template <class Space>
double balance(Body<Space>& body, QuasiStaticStep<Space>& step, const StageLoad& load, const Gravity& gravity,
               StageReport& stage, double share = 1.0, Eigen::VectorXd support_motion = {}) {
  double part = share, carried = 0.0;
  while (true) {
    require_touched(body, load, support_motion);
    IncrementReport report = step.advance(body, gravity, part, part / share * support_motion);
    stage.linear_solves += report.linear_solves;
    if (!report.converged) {
      part *= 0.5;
      if (part >= smallest_fraction * share) continue;
      if (load.may_fail) return carried;
      give_up(load, gravity, report, carried);
    }
    ++stage.steps;
    stage.out_of_balance = report.out_of_balance;
    stage.base_reaction = report.base_reaction;
    stage.reactions = std::move(report.reactions);
    if (part >= share) return 1.0;
    carried += (1.0 - carried) * part / share;
    support_motion *= 1.0 - part / share; // what is left of it
    share = (share - part) / (1.0 - part);
    part = std::min(share, 2.0 * part);
  }
}

} // namespace

template <class Space>
StageReport load_quasi_static(Body<Space>& body, const StageLoad& load, const exchange::QuasiStatic& settings,
                              int threads) {
  QuasiStaticStep<Space> step(settings.residual, settings.linear_solver.value_or(exchange::MpmLinearSolver::direct),
                              {.most = threads});
  StageReport stage;
  const bool releases = load.action == exchange::Action::remove;
  const int increments = load.grows() || releases ? settings.increments : 1;
  const auto share = [&](int increment) { return static_cast<double>(increment) / increments; };
  for (int increment = 1; increment <= increments; ++increment) {
    Eigen::VectorXd support_motion;
    if (load.drive != nullptr)
      support_motion = load.drive->support_motion(load.layer, share(increment - 1), share(increment),
                                                  Space::dim * body.space.n_nodes());
    const double of_rest = releases ? 1.0 / (increments + 1 - increment) : 1.0;
    const double carried =
        balance(body, step, load, load.at(share(increment)), stage, of_rest, std::move(support_motion));
    if (carried < 1.0) {
      stage.failed_at = (increment - 1 + carried) / increments;
      stage.in_equilibrium = true; // as the last part that found it has left the body
      return stage;
    }
    if (increment < increments) refill_where_due(body, load.refill);
  }
  for (int k = 0; close_gap(body, load.refill) > 0; ++k) {
    if (k == max_closing_increments)
      throw exchange::NotConverged({.where = fmt::format("stage {}", load.number),
                                    .what = "refilling does not come to an end",
                                    .given = fmt::format("{} increments at full gravity", k),
                                    .allowed = "",
                                    .remedy = "check youngs_modulus against the weight: the column may be too soft"});
    balance(body, step, load, load.at(1.0), stage);
  }
  stage.in_equilibrium = true;
  return stage;
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template StageReport load_quasi_static(Body<Space>&, const StageLoad&, const exchange::QuasiStatic&, int);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
