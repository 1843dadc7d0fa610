#include "settle/compare/exact_solution.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "settle/compare/exact_column.hpp"
#include "settle/compare/statistics.hpp"
#include "settle/exchange/formulas.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::compare {

using exchange::Case;
using exchange::Quantity;

namespace {

class ColumnSolution : public ExactSolution {
public:
  ColumnSolution(const Case& study, exchange::Kinematics kinematics)
      : column_(study, kinematics), thickness_(study.layer_thickness()), area_(plan_area(study)),
        gravity_(study.gravity), dimension_(study.geometry.dimension) {}

  [[nodiscard]] std::string lacks(Quantity quantity) const override {
    if (quantity == Quantity::plastic_strain) return "the columns that are known in closed form do not yield";
    const bool of_drawn =
        quantity == Quantity::support_reaction || quantity == Quantity::failure_height || quantity == Quantity::thrust;
    return of_drawn ? "a column has no such thing" : "";
  }

  [[nodiscard]] MaterialState at(const MaterialPoint& point, int stage) const override {
    return of(column_.at(point.layer, relative_height(point), stage));
  }

  [[nodiscard]] double scalar(Quantity quantity, int stage) const override {
    if (quantity == Quantity::mass) return column_.base_stress(stage) * area_ / gravity_;
    if (quantity == Quantity::base_reaction) return column_.base_stress(stage) * area_;
    return column_.mean_density(stage);
  }

  [[nodiscard]] std::optional<MaterialState> in_thin_layers(const MaterialPoint& point) const override {
    return of(column_.in_thin_layers((point.layer - 1 + relative_height(point)) * thickness_));
  }

  [[nodiscard]] std::optional<MaterialState> under(double surcharge, const MaterialPoint& point,
                                                   int stage) const override {
    return of(column_.at(point.layer, relative_height(point), stage, surcharge));
  }

private:
  [[nodiscard]] double relative_height(const MaterialPoint& point) const {
    return point.as_placed ? column_.relative_height(point.layer, point.height)
                           : point.height / thickness_ - (point.layer - 1);
  }

  /// No lateral strain, no shear; the vertical is the last axis of the space.
  [[nodiscard]] MaterialState of(const ColumnState& state) const {
    const auto vertical = static_cast<std::size_t>(dimension_ - 1);
    MaterialState whole;
    whole.displacement[vertical] = -state.settlement;
    whole.stress = {state.lateral_stress, state.lateral_stress, state.lateral_stress, 0.0, 0.0, 0.0};
    whole.stress[vertical] = state.vertical_stress;
    return whole;
  }

  ExactColumn column_;
  double thickness_, area_, gravity_;
  int dimension_;
};

/// A body of polygons, whose motion is what the case says; placed where it is designed.
class StatedSolution : public ExactSolution {
public:
  explicit StatedSolution(const Case& study) : study_(study) {
    if (study.motion) formulas_.emplace(study);
  }

  [[nodiscard]] std::string lacks(Quantity quantity) const override {
    switch (quantity) {
    case Quantity::mass:
      return {};
    case Quantity::base_reaction:
      return other_load_of(study_);
    case Quantity::density:
      return "the mean density of a body that moves is not among the formulas of a case";
    case Quantity::plastic_strain:
      return "plastic strain is not among the formulas of a case";
    case Quantity::thrust:
      return "what each support carries is not among the formulas of a case";
    case Quantity::settlement:
    case Quantity::displacement:
      return formulas_ ? std::string() : "nothing is known to be exact: the case has no [motion]";
    case Quantity::vertical_stress:
    case Quantity::lateral_stress:
    case Quantity::shear_stress:
    case Quantity::stress:
      if (!formulas_) return "nothing is known to be exact: the case has no [motion]";
      return formulas_->has_stress() ? std::string() : "the case's [motion] does not state the stress";
    case Quantity::support_reaction:
    case Quantity::failure_height:
      return "the check does not state its exact value";
    }
    return {};
  }

  [[nodiscard]] MaterialState at(const MaterialPoint& point, int stage) const override {
    const exchange::FormulaPoint where{.x = point.x,
                                       .y = point.height,
                                       .time = study_.motion->duration.value_or(0.0),
                                       .layer = point.layer,
                                       .stage = stage};
    const auto displacement = formulas_->displacement(where);
    const auto stress = formulas_->stress(where);
    MaterialState state;
    std::copy(displacement.begin(), displacement.end(), state.displacement.begin());
    std::copy(stress.begin(), stress.end(), state.stress.begin());
    return state;
  }

  [[nodiscard]] double scalar(Quantity quantity, int stage) const override {
    double mass = 0.0;
    for (const int layer : study_.layers_present(stage))
      mass += study_.material_of(layer).density * exchange::layer_area(study_.geometry, layer);
    if (quantity == Quantity::mass) return mass;
    return quantity == Quantity::base_reaction ? study_.gravity * mass : std::nan("");
  }

  [[nodiscard]] std::optional<MaterialState> in_thin_layers(const MaterialPoint&) const override { return {}; }
  [[nodiscard]] std::optional<MaterialState> under(double, const MaterialPoint&, int) const override { return {}; }

private:
  Case study_;
  std::optional<exchange::Formulas> formulas_;
};

} // namespace

std::unique_ptr<ExactSolution> exact_solution(const Case& study, exchange::Kinematics kinematics) {
  if (study.geometry.drawn()) return std::make_unique<StatedSolution>(study);
  return std::make_unique<ColumnSolution>(study, kinematics);
}

std::string other_load_of(const Case& study) {
  const bool follows = std::any_of(study.supports.begin(), study.supports.end(), [](const exchange::Support& support) {
    return support.motion == exchange::SupportMotion::exact;
  });
  if (follows) return "supports that follow a motion carry whatever it takes, not just the weight";
  if (!study.motion) return {};
  if (study.motion->duration) return "supports of a body in motion carry its inertia, not just its weight";
  return study.motion->body_force.empty() ? std::string() : "supports carry the body force besides the weight";
}

} // namespace settle::compare
