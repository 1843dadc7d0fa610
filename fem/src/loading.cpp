#include "loading.hpp"

namespace settle::fem {

using exchange::PlanePoint;

Loading::Loading(const exchange::Case& study) : stages_(study.all_stages()) {
  if (!study.motion) return;
  formulas_.emplace(study);
  duration_ = study.motion->duration;
  drives_ = !study.motion->body_force.empty() || (duration_ && !study.motion->acceleration.empty());
}

std::optional<double> Loading::time(const Progress& at) const {
  if (!duration_) return {};
  return at.share * *duration_;
}

double Loading::gravity_factor(int layer, const Progress& at) const {
  if (duration_ || !places(at.stage, layer)) return 1.0;
  return stages_[static_cast<std::size_t>(at.stage - 1)].k0 ? 1.0 : at.share;
}

PlanePoint Loading::driving_force(const PlacedPoint& point, const Progress& at) const {
  const std::lock_guard guard(formulas_in_use_);
  const exchange::FormulaPoint formula_point = this->formula_point(point, at);
  const PlanePoint body = formulas_->body_force(formula_point);
  const double factor = gravity_factor(point.layer, at);
  if (!duration_) return {factor * body[0], factor * body[1]};
  const PlanePoint acceleration = formulas_->acceleration(formula_point);
  return {body[0] - acceleration[0], body[1] - acceleration[1]};
}

PlanePoint Loading::displacement_in_stage(const PlacedPoint& point, const Progress& at) const {
  const std::lock_guard guard(formulas_in_use_);
  const PlanePoint now = formulas_->displacement(formula_point(point, at));
  if (!duration_ && places(at.stage, point.layer)) return {at.share * now[0], at.share * now[1]};
  const Progress start = duration_ ? Progress{at.stage, 0.0} : Progress{at.stage - 1, 1.0};
  const PlanePoint before = formulas_->displacement(formula_point(point, start));
  const double share = duration_ ? 1.0 : at.share;
  return {share * (now[0] - before[0]), share * (now[1] - before[1])};
}

exchange::FormulaPoint Loading::formula_point(const PlacedPoint& point, const Progress& at) const {
  return {.x = point.position[0],
          .y = point.position[1],
          .time = time(at).value_or(0.0),
          .layer = point.layer,
          .stage = at.stage};
}

bool Loading::places(int stage, int layer) const {
  const exchange::StageEntry& entry = stages_.at(static_cast<std::size_t>(stage - 1));
  const bool placed = entry.action == exchange::Action::place || entry.action == exchange::Action::ground;
  return placed && entry.layer == layer;
}

} // namespace settle::fem
