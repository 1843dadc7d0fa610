/// \file
/// A construction in progress: what the stages of a case do to a body.
#pragma once

#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

#include "construction.hpp"
#include "ground.hpp"
#include "load_carriers.hpp"
#include "loaded_parts.hpp"
#include "moves.hpp"
#include "polygon_construction.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "settle/mpm/loading.hpp"
#include "stage_record.hpp"

namespace settle::mpm {

template <class Space>
class Builder {
public:
  static constexpr int dim = Space::dim;

  /// The case outlives its construction.
  explicit Builder(const exchange::Case& study)
      : study_(study), body_(empty_body<Space>(study)), drive_(drive_of(study, body_.space)) {}

  /// What has become of a stage.
  struct Built {
    exchange::Stage stage{};
    std::optional<double> failed_at{}; ///< as in StageReport
  };

  /// Stage 1, 2, ... from what the one before has left.
  Built build(int number) {
    const auto start = std::chrono::steady_clock::now();
    StageLoad stage_load = load_of(number);
    exchange::Stage stage;
    stage.layer = stage_load.layer;
    begin(study_.stages[static_cast<std::size_t>(number - 1)], stage_load, stage);
    first_refilled_ = body_.points.next_id;
    const StageReport report = load(stage_load);
    if (study_.geometry.drawn()) design_.note_refilled(body_.points);
    if (stage_load.action == exchange::Action::ground) forget_displacements(body_.points);
    record(report, stage);
    stage.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return {std::move(stage), report.failed_at};
  }

  /// Does the scheme go on after failure?
  [[nodiscard]] bool runs_out() const { return is_explicit(); }

  /// After a stage that failed: from the state in equilibrium last to rest.
  exchange::RunOut run_out(int number) {
    const auto start = std::chrono::steady_clock::now();
    StageLoad stage_load = load_of(number);
    if (!loads_.empty()) stage_load.loads = &loads_;
    const Points<dim> before = body_.points;
    exchange::RunOut result{.mass_before = total_mass(before),
                            .points_before = static_cast<std::int64_t>(before.size())};
    const RunOutReport report = mpm::run_out(body_, stage_load, study_.mpm.explicit_dynamic, study_.mpm.threads);
    result.at_rest = report.at_rest, result.duration = report.duration;
    result.external_work = report.external_work, result.stress_work = report.stress_work;
    result.damping_loss = report.damping_loss;
    result.kinetic_energy = kinetic_energy(body_.points) - kinetic_energy(before);
    result.largest_displacement = largest_move(before, body_.points);
    result.distance = reach_beyond(before, body_.points);
    result.state.layer = stage_load.layer;
    record(report.stage, result.state);
    result.state.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
  }

private:
  const exchange::Case& study_;
  Body<Space> body_;
  std::unique_ptr<const Drive> drive_;
  std::vector<LayerPlacement> placements_; ///< of a column's layers
  std::vector<int> present_;               ///< layers that are drawn and there, the one placed last comes last
  Design design_{study_};
  LayerColumns designed_;            ///< of a body that is drawn and refilled
  std::uint64_t first_refilled_ = 1; ///< of the points that a stage has added to make up for settlement, the first
  SurfaceLoads loads_;

  [[nodiscard]] bool is_explicit() const { return study_.mpm.scheme == exchange::Scheme::explicit_dynamic; }

  static std::unique_ptr<const Drive> drive_of(const exchange::Case& study, const Space& space) {
    if constexpr (dim == 2)
      if (study.motion) {
        const Inertia inertia = study.mpm.scheme == exchange::Scheme::quasi_static ? Inertia::taken_off : Inertia::felt;
        return std::make_unique<const Drive>(study, inertia, following_nodes(study, space));
      }
    return nullptr;
  }

  [[nodiscard]] StageLoad load_of(int number) {
    const exchange::StageEntry& entry = study_.stages[static_cast<std::size_t>(number - 1)];
    return {.number = number,
            .layer = entry.layer,
            .gravity = study_.gravity,
            .action = entry.action,
            .may_fail = study_.construction.may_fail,
            .failure_distance = study_.mpm.explicit_dynamic.failure_displacement * fill_height(),
            .starts_carried = entry.k0.has_value(),
            .refill = refill_of(study_, number, body_, designed_),
            .drive = drive_.get()};
  }

  /// As designed; of ground alone, its own [m].
  [[nodiscard]] double fill_height() const {
    const double height = exchange::fill_height(study_, study_.n_stages(), 1.0);
    return height > 0.0 ? height : study_.geometry.height;
  }

  void begin(const exchange::StageEntry& entry, StageLoad& stage_load, exchange::Stage& stage) {
    switch (entry.action) {
    case exchange::Action::ground:
    case exchange::Action::place:
      stage.mass_placed = place(entry);
      break;
    case exchange::Action::remove:
      if (is_explicit()) stage.steps = fade(stage_load);
      stage.mass_placed = -remove_layer(body_.points, entry.layer);
      present_.erase(std::find(present_.begin(), present_.end(), entry.layer));
      body_.sort();
      break;
    case exchange::Action::load:
      put_on(entry);
      break;
    case exchange::Action::hold:
      break;
    }
    if (!loads_.empty()) stage_load.loads = &loads_;
  }

  void put_on(const exchange::StageEntry& load) {
    const double spacing = body_.space.size() / body_.layout.row_points;
    const LoadCarriers carriers(design_.layers(body_.points, present_), cells_of_carriers(study_, body_),
                                body_.space.size());
    loads_.add(loaded_parts(study_, load, {present_.begin(), present_.end()}, spacing), carriers, body_.points.id);
  }

  /// Returns the mass [kg/m in 2-D].
  double place(const exchange::StageEntry& entry) {
    const double mass_before = total_mass(body_.points);
    if (study_.geometry.drawn())
      place_drawn(entry);
    else
      place_in_column(entry.layer);
    return total_mass(body_.points) - mass_before;
  }

  void place_drawn(const exchange::StageEntry& entry) {
    place_polygons(study_, entry.layer, present_, design_, body_);
    present_.push_back(entry.layer);
    if (entry.k0) set_level_stress(study_, entry.layer, body_.points);
    body_.sort();
  }

  void place_in_column(int layer) {
    placements_.push_back(placement_of(study_, layer, body_));
    place_layer(body_, placements_.back());
    body_.sort();
    if (study_.construction.convention == exchange::Convention::drop && !is_explicit())
      require_supported(study_, placements_.back(), body_);
  }

  std::int64_t fade(const StageLoad& stage_load) {
    StageLoad fading = stage_load;
    if (!loads_.empty()) fading.loads = &loads_;
    return fade_explicit(body_, fading, study_.mpm.explicit_dynamic, study_.mpm.threads).steps;
  }

  StageReport load(const StageLoad& stage_load) {
    if (!is_explicit()) return load_quasi_static(body_, stage_load, study_.mpm.quasi_static, study_.mpm.threads);
    if constexpr (dim == 2)
      if (stage_load.drive != nullptr && stage_load.drive->runs_in_time())
        return run_motion(body_, stage_load, study_.mpm.explicit_dynamic.courant, study_.mpm.threads);
    const auto to_equilibrium = stage_load.may_fail ? load_until_failure<Space> : load_explicit<Space>;
    return to_equilibrium(body_, stage_load, study_.mpm.explicit_dynamic, study_.mpm.threads);
  }

  void record(const StageReport& report, exchange::Stage& stage) const {
    stage.steps += report.steps;
    stage.linear_solves = report.linear_solves;
    stage.out_of_balance = report.out_of_balance;
    stage.in_equilibrium = report.in_equilibrium;
    stage.base_reaction = report.base_reaction;
    stage.mass = total_mass(body_.points);
    stage.mass_refilled = refilled_mass(body_.points, first_refilled_);
    stage.weight =
        study_.gravity * (stage.mass - (1.0 - report.failed_at.value_or(1.0)) * stage.mass_placed); // what acts
    stage.points = sample_points(body_.points);
    if (study_.geometry.drawn()) return record_drawn(report, stage);
    stage.surface_height = surface_height(body_, study_.construction.convention);
    stage.probes = sample_probes(study_, body_.points, placements_);
  }

  void record_drawn(const StageReport& report, exchange::Stage& stage) const {
    const double spacing = body_.space.size() / body_.layout.row_points;
    stage.surface_height = highest_surface(body_.points, dim == 2 ? 1.0 : spacing, spacing);
    stage.probes = sample_drawn_probes(study_, body_.points, design_, present_);
    if (report.reactions.size() > 0) stage.support_reactions = support_reactions(study_, body_.space, report.reactions);
  }
};

} // namespace settle::mpm
