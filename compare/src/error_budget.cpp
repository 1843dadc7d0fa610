#include "settle/compare/error_budget.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "leg_side.hpp"
#include "settle/compare/exact_solution.hpp"
#include "settle/compare/legs.hpp"
#include "settle/compare/statistics.hpp"

namespace settle::compare {

using exchange::Norm;
using exchange::Over;
using exchange::Quantity;

namespace {

/// A field at all probes, (n, c); empty where it is not known.
using Field = std::vector<double>;

Field difference(const Field& a, const Field& b) {
  if (a.size() != b.size()) return {};
  Field result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    result[i] = a[i] - b[i];
  return result;
}

/// One solver's end of the leg: what it found at the last stage, and what is exact of the model it solves.
class SolverSide {
public:
  SolverSide(const RunOutcome& run, const std::string& solver, Quantity quantity)
      : result_(*run.result_of(solver)), exact_(exact_solution(run.study, result_.used.kinematics)),
        number_(run.study.n_stages()), stage_(stage_of(result_, number_)), quantity_(quantity),
        dimension_(run.study.geometry.dimension), area_(plan_area(run.study)), gravity_(run.study.gravity),
        probes_(probe_samples(stage_, dimension_, quantity)) {}

  [[nodiscard]] Field exact() const {
    return field([&](const MaterialPoint& point) { return exact_->at(point, number_); });
  }
  /// What the finite number of layers changes.
  [[nodiscard]] Field of_layers() const {
    return difference(exact(), field([&](const MaterialPoint& point) { return exact_->in_thin_layers(point); }));
  }
  /// What so much more weight on the surface changes [Pa].
  [[nodiscard]] Field of_surcharge(double surcharge) const {
    const auto loaded = [&](const MaterialPoint& point) { return exact_->under(surcharge, point, number_); };
    return difference(field(loaded), exact());
  }
  /// Weight of the mass that the solver has and the exact solution has not, per plan area [Pa].
  [[nodiscard]] double excess_weight() const {
    return gravity_ * (stage_.mass - exact_->scalar(Quantity::mass, number_)) / area_;
  }
  /// Force that the last increment or step left unbalanced, per plan area [Pa]: the larger of what the solver states
  /// and what its base reaction shows.
  [[nodiscard]] double unbalanced() const {
    return std::max(std::abs(stage_.base_reaction - stage_.weight), stage_.out_of_balance * stage_.weight) / area_;
  }

private:
  [[nodiscard]] Field field(const std::function<std::optional<MaterialState>(const MaterialPoint&)>& state_at) const {
    Field values;
    for (std::size_t i = 0; i < probes_.size(); ++i) {
      const auto state =
          state_at({.layer = probes_.layer[i], .x = probes_.x[i], .height = probes_.height[i], .as_placed = false});
      if (!state) return {};
      append_field(*state, dimension_, quantity_, values);
    }
    return values;
  }

  const exchange::Result& result_;
  std::unique_ptr<ExactSolution> exact_;
  int number_;
  const exchange::Stage& stage_;
  Quantity quantity_;
  int dimension_;
  double area_, gravity_;
  FieldSamples probes_;
};

/// The usual fields, then those that a check compares between the two solvers.
std::vector<Quantity> quantities_of(const exchange::Case& study) {
  std::vector<Quantity> quantities = usual_fields(study);
  for (const exchange::Check& check : study.checks) {
    const bool of_both = std::count(check.between.begin(), check.between.end(), "mpm") == 1 &&
                         std::count(check.between.begin(), check.between.end(), "fem") == 1;
    const bool known = std::count(quantities.begin(), quantities.end(), check.quantity) > 0;
    if (of_both && !known && is_field(check.quantity)) quantities.push_back(check.quantity);
  }
  return quantities;
}

/// The three legs of a difference; empty samples where there is nothing to compare.
struct Legs {
  LegSamples total, mpm, fem;

  Legs(const RunOutcome& run, Quantity quantity) {
    const auto leg = [&](const std::string& value, const std::string& reference) {
      return leg_samples(run, {.value = value,
                               .reference = reference,
                               .quantity = quantity,
                               .over = Over::probes,
                               .stage = run.study.n_stages()});
    };
    total = leg("mpm", "fem");
    mpm = leg("mpm", "exact");
    fem = leg("fem", "exact");
  }
  [[nodiscard]] bool complete() const {
    return total.size() > 0 && mpm.size() == total.size() && fem.size() == total.size();
  }
};

DifferenceSplit split_of(const RunOutcome& run, Quantity quantity, const Legs& legs) {
  const double scale = norm_of(legs.fem.reference, legs.fem.weight, Norm::l2);
  const auto leg_part = [&](const LegSamples& leg) { return relative_norm(leg, Norm::l2, scale).value; };
  const auto part = [&](const Field& field) {
    return field.empty() ? std::nan("") : norm_of(field, legs.fem.weight, Norm::l2) / scale;
  };
  const LegSamples model{.value = legs.mpm.reference, .reference = legs.fem.reference, .weight = legs.fem.weight};
  const SolverSide mpm(run, "mpm", quantity), fem(run, "fem", quantity);
  const Field mpm_layers = mpm.of_layers(), fem_layers = fem.of_layers();
  return {.quantity = quantity,
          .total = leg_part(legs.total),
          .mpm_error = leg_part(legs.mpm),
          .model_difference = leg_part(model),
          .fem_error = leg_part(legs.fem),
          .scale = scale,
          .mpm_mass = part(mpm.of_surcharge(mpm.excess_weight())),
          .mpm_unbalanced = part(mpm.of_surcharge(mpm.unbalanced())),
          .fem_unbalanced = part(fem.of_surcharge(fem.unbalanced())),
          .layers = part(difference(mpm_layers, fem_layers)),
          .mpm_layers = part(mpm_layers),
          .fem_layers = part(fem_layers)};
}

} // namespace

std::vector<DifferenceSplit> difference_splits(const RunOutcome& run) {
  std::vector<DifferenceSplit> splits;
  for (const Quantity quantity : quantities_of(run.study)) {
    const Legs legs(run, quantity);
    if (legs.complete()) splits.push_back(split_of(run, quantity, legs));
  }
  return splits;
}

} // namespace settle::compare
