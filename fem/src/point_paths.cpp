#include "point_paths.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

#include "materials.hpp"
#include "settle/exchange/errors.hpp"
#include "soil/mixed_control.hpp"

namespace settle::fem {
namespace {

using exchange::PathLeg;

/// Where a leg stands, for messages and to find it again.
struct Leg {
  const PathLeg& path;
  int number; ///< of its point, from 1
};

exchange::NotConverged not_followed(const exchange::Case& study, const Leg& leg, int step,
                                    const std::optional<MixedResult>& result) {
  return exchange::NotConverged(exchange::Complaint{
      .where = study.file,
      .what = fmt::format("point {} cannot follow step {} of {} of its leg {}", leg.path.point, step,
                          leg.path.increments, leg.number),
      .given = result ? fmt::format("stresses are off by {:.3g} of the largest", fmt::join(result->residuals, ", "))
                      : std::string("strain for which its law has no stress"),
      .allowed = "",
      .remedy = "look for a stress that the material cannot carry, or raise the increments of the leg"});
}

/// What a leg does to a point in each of its steps: shares of the strain, and stresses from its start.
MixedStep step_of(const PathLeg& leg, const dealii::SymmetricTensor<2, 3>& start, int step) {
  MixedStep mixed;
  for (std::size_t c = 0; c < 6; ++c) {
    mixed.stress_given[c] = leg.control[c] == "stress";
    const double share = mixed.stress_given[c] ? step : 1;
    mixed.values[c] = leg.increment[c] * share / leg.increments;
    if (mixed.stress_given[c]) mixed.values[c] += start[places_of_components[c][0]][places_of_components[c][1]];
  }
  return mixed;
}

struct Followed {
  SoilPoint point;
  double residual = 0.0; ///< largest of the leg's steps [-]
};

Followed follow_leg(const exchange::Case& study, const SoilLaw& law, const SoilPoint& start, const Leg& leg) {
  Followed followed{start};
  for (int step = 1; step <= leg.path.increments; ++step) {
    const auto result = follow(law, followed.point, step_of(leg.path, start.stress, step));
    if (!result || !result->reached()) throw not_followed(study, leg, step, result);
    followed.point = result->point;
    followed.residual = std::max(followed.residual, result->residuals.back());
  }
  return followed;
}

/// The legs of a point, in their order.
std::vector<Leg> legs_of(const exchange::Case& study, int point) {
  std::vector<Leg> legs;
  for (const PathLeg& path : study.paths)
    if (path.point == point) legs.push_back({path, static_cast<int>(legs.size()) + 1});
  return legs;
}

SoilPoint initial_point(const exchange::Case& study) {
  SoilPoint point{{}, state_as_placed(study.fill())};
  for (std::size_t c = 0; c < 6; ++c)
    point.stress[places_of_components[c][0]][places_of_components[c][1]] = study.initial.stress[c];
  return point;
}

/// A point has no extent: it stands at the origin, and stands for a volume of one.
void append(const exchange::Case& study, int id, const SoilPoint& point, exchange::SamplePoints& points) {
  const auto dimension = static_cast<std::size_t>(study.geometry.dimension);
  points.id.push_back(static_cast<std::uint64_t>(id));
  points.layer.push_back(1);
  points.refilled.push_back(0);
  for (auto* vector : {&points.placed_position, &points.position, &points.displacement})
    vector->insert(vector->end(), dimension, 0.0);
  const std::array<double, 6> stress = six_components(point.stress);
  points.stress.insert(points.stress.end(), stress.begin(), stress.end());
  points.density.push_back(study.fill().density);
  points.volume.push_back(1.0);
  points.plastic_strain.push_back(point.variables.plastic_strain);
  if (study.fill().law == exchange::Law::cam_clay)
    points.preconsolidation_pressure.push_back(point.variables.preconsolidation_pressure);
}

} // namespace

void follow_paths(const exchange::Case& study, const StageSink& on_stage) {
  using Clock = std::chrono::steady_clock;
  const SoilLaw law = soil_law(study.fill());
  std::vector<std::vector<Leg>> legs;
  for (const PathLeg& path : study.paths)
    while (static_cast<int>(legs.size()) < path.point)
      legs.push_back(legs_of(study, static_cast<int>(legs.size()) + 1));
  std::vector<SoilPoint> points(legs.size(), initial_point(study));
  for (int stage_number = 1; stage_number <= study.n_stages(); ++stage_number) {
    const Clock::time_point start = Clock::now();
    exchange::Stage stage;
    stage.layer = 1;
    stage.in_equilibrium = true;
    for (std::size_t p = 0; p < points.size(); ++p) {
      const Leg& leg = legs[p].at(static_cast<std::size_t>(stage_number - 1));
      const Followed followed = follow_leg(study, law, points[p], leg);
      points[p] = followed.point;
      stage.out_of_balance = std::max(stage.out_of_balance, followed.residual);
      stage.steps = std::max<std::int64_t>(stage.steps, leg.path.increments);
      append(study, static_cast<int>(p) + 1, points[p], stage.points);
    }
    stage.wall_time = std::chrono::duration<double>(Clock::now() - start).count();
    on_stage(stage);
  }
}

} // namespace settle::fem
