#include "settle/mpm/explicit_step.hpp"

#include <optional>

#include "kernel_step.hpp"
#include "pointwise_step.hpp"

namespace settle::mpm {

template <class Space>
class ExplicitStep<Space>::Phases {
public:
  Phases(Body<Space>& body, int threads, bool loaded) {
    if (body.materials.empty() && !(dim == 3 && loaded))
      fast_.emplace(body, threads);
    else
      pointwise_.emplace(body, threads);
  }
  /// Calls `action` with the steps of this body.
  template <class Action>
  auto with(Action&& action) {
    return fast_ ? action(*fast_) : action(*pointwise_);
  }
  Nodes<dim> nodes; ///< as read last

private:
  /// Kernels know bodies of one simple material, in space without forces but gravity.
  using Fast = std::conditional_t<has_kernels<Space>, KernelStep<Space>, PointwiseStep<Space>>;
  std::optional<Fast> fast_;
  std::optional<PointwiseStep<Space>> pointwise_;
};

template <class Space>
ExplicitStep<Space>::ExplicitStep(Body<Space>& body, int threads, bool loaded)
    : phases_(std::make_unique<Phases>(body, threads, loaded)) {}
template <class Space>
ExplicitStep<Space>::ExplicitStep(ExplicitStep&&) noexcept = default;
template <class Space>
ExplicitStep<Space>::~ExplicitStep() = default;

template <class Space>
void ExplicitStep<Space>::scatter(const Gravity& gravity) {
  phases_->with([&](auto& step) { step.scatter(gravity); });
}
template <class Space>
double ExplicitStep<Space>::stable_time_step(double courant) const {
  return phases_->with([&](auto& step) { return step.stable_time_step(courant); });
}
template <class Space>
std::vector<double> ExplicitStep<Space>::column_heights() const {
  return phases_->with([&](auto& step) { return step.column_heights(); });
}
template <class Space>
ForceSums ExplicitStep<Space>::accelerate(double damping) {
  return phases_->with([&](auto& step) { return step.accelerate(damping); });
}
template <class Space>
StepEnergy ExplicitStep<Space>::displace(double kick, double dt, double kept) {
  return phases_->with([&](auto& step) { return step.displace(kick, dt, kept); });
}
template <class Space>
void ExplicitStep<Space>::move() {
  phases_->with([&](auto& step) { step.move(); });
}
template <class Space>
void ExplicitStep<Space>::gather() {
  phases_->with([&](auto& step) { step.gather(); });
}
template <class Space>
auto ExplicitStep<Space>::node(int node) const -> NodeState<dim> {
  return phases_->with([&](auto& step) { return step.node(node); });
}
template <class Space>
auto ExplicitStep<Space>::nodes() -> const Nodes<dim>& {
  phases_->with([&](auto& step) { step.read_nodes(phases_->nodes); });
  return phases_->nodes;
}
template <class Space>
void ExplicitStep<Space>::set_displacement(int node, const Vector<dim>& displacement) {
  phases_->with([&](auto& step) { step.set_displacement(node, displacement); });
}

#define SETTLE_INSTANTIATE(Space) template class ExplicitStep<Space>;
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
