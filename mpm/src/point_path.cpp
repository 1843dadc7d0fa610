#include "settle/mpm/point_path.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <Eigen/QR>
#include <fmt/ranges.h>

#include "settle/exchange/errors.hpp"
#include "settle/mpm/material.hpp"

namespace settle::mpm {

namespace {

constexpr int most_iterations = 60;
/// Missing stress over the stresses of a step, by which an increment has converged: some round-offs of the trial.
constexpr double allowed = 1e-12;
/// Below this ratio of pivots two strains do the same to the stresses given.
constexpr double dependent = 1e-9;

/// Columns of the components whose stress is given.
Eigen::MatrixXd selection(const std::array<bool, 6>& by_stress) {
  Eigen::MatrixXd pick = Eigen::MatrixXd::Zero(6, std::count(by_stress.begin(), by_stress.end(), true));
  for (int i = 0, k = 0; i < 6; ++i)
    if (by_stress[static_cast<std::size_t>(i)]) pick(i, k++) = 1.0;
  return pick;
}

/// Largest component of what is missing over the largest stress there is or has been on the way: the trial's.
double relative(const Eigen::VectorXd& missing, const soil::Update& end, const soil::Voigt& strain,
                const Eigen::VectorXd& target) {
  const double trial = end.tangent.cwiseAbs().maxCoeff() * strain.cwiseAbs().maxCoeff();
  const double scale = std::max({end.stress.cwiseAbs().maxCoeff(), target.cwiseAbs().maxCoeff(), trial});
  return scale > 0.0 ? missing.cwiseAbs().maxCoeff() / scale : 0.0;
}

std::size_t size_of(int i) {
  return static_cast<std::size_t>(i);
}

/// The legs of a point, in order.
std::vector<exchange::PathLeg> legs_of(const exchange::Case& study, int point) {
  std::vector<exchange::PathLeg> legs;
  std::copy_if(study.paths.begin(), study.paths.end(), std::back_inserter(legs),
               [&](const exchange::PathLeg& leg) { return leg.point == point; });
  return legs;
}

[[noreturn]] void give_up(const exchange::PathLeg& leg, int stage, int increment, const MixedReport& report) {
  throw exchange::NotConverged(
      {.where = fmt::format("point {}, leg {}, increment {} of {}", leg.point, stage, increment, leg.increments),
       .what = "the stress that is given cannot be reached",
       .given = fmt::format("missing stress over the stresses there, by iteration: {:.2e}",
                            fmt::join(report.residuals, ", ")),
       .allowed = fmt::format("{:g}", allowed),
       .remedy = "take more increments; beyond its strength a soil bears no more: control a strain there"});
}

/// One leg of one point; returns how many linear systems were solved.
int run_leg(const soil::Soil& soil, const exchange::PathLeg& leg, int stage, PointState& point) {
  MixedStep step;
  soil::Voigt whole, strain_of_leg = soil::Voigt::Zero();
  for (int i = 0; i < 6; ++i) {
    whole[i] = leg.increment[size_of(i)];
    step.by_stress[size_of(i)] = leg.control[size_of(i)] == "stress";
    if (!step.by_stress[size_of(i)]) strain_of_leg[i] = (i < 3 ? 1.0 : 2.0) * whole[i] / leg.increments;
  }
  const soil::Voigt stress_at_start = point.stress;
  int solves = 0;
  for (int increment = 1; increment <= leg.increments; ++increment) {
    step.strain = strain_of_leg;
    step.stress = stress_at_start + static_cast<double>(increment) / leg.increments * whole;
    const MixedReport report = take_step(soil, point, step);
    if (!report.converged) give_up(leg, stage, increment, report);
    solves += static_cast<int>(report.residuals.size()) - 1;
    point = {report.end.stress, report.end.state};
  }
  return solves;
}

exchange::SamplePoints samples_of(const std::vector<PointState>& points, const Material& material, int dimension) {
  const std::size_t n = points.size(), dim = size_of(dimension);
  exchange::SamplePoints samples;
  samples.layer.assign(n, 1), samples.refilled.assign(n, 0);
  samples.placed_position.assign(n * dim, 0.0);
  samples.position = samples.displacement = samples.placed_position;
  samples.density.assign(n, material.density), samples.volume.assign(n, 1.0);
  for (std::size_t p = 0; p < n; ++p) {
    samples.id.push_back(p + 1);
    samples.stress.insert(samples.stress.end(), points[p].stress.begin(), points[p].stress.end());
    if (yields(material.law)) samples.plastic_strain.push_back(points[p].state.plastic_strain);
    if (material.law == exchange::Law::cam_clay)
      samples.preconsolidation_pressure.push_back(points[p].state.preconsolidation_pressure);
  }
  return samples;
}

} // namespace

MixedReport take_step(const soil::Soil& soil, const PointState& start, const MixedStep& step) {
  const Eigen::MatrixXd pick = selection(step.by_stress);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> system(pick.cols(), pick.cols());
  system.setThreshold(dependent);
  MixedReport report;
  report.strain = step.strain;
  for (int iteration = 0; iteration <= most_iterations; ++iteration) {
    report.end = soil::update(soil, start.stress, start.state, report.strain, soil::Wanted::tangent);
    const Eigen::VectorXd missing = pick.transpose() * (step.stress - report.end.stress);
    report.residuals.push_back(
        pick.cols() > 0 ? relative(missing, report.end, report.strain, pick.transpose() * step.stress) : 0.0);
    report.converged = report.residuals.back() <= allowed && report.end.stress.allFinite();
    if (report.converged || !std::isfinite(report.residuals.back())) break;
    report.strain += pick * system.compute(pick.transpose() * report.end.tangent * pick).solve(missing);
  }
  return report;
}

void drive_points(const exchange::Case& study, const exchange::StageSink& sink) {
  const Material material = material_of(study.fill());
  PointState start{.stress = Eigen::Map<const soil::Voigt>(study.initial.stress.data())};
  start.state.preconsolidation_pressure = material.preconsolidation_pressure();
  std::vector<std::vector<exchange::PathLeg>> legs;
  for (int point = 1; !legs_of(study, point).empty(); ++point)
    legs.push_back(legs_of(study, point));
  std::vector<PointState> points(legs.size(), start);
  for (int number = 1; number <= study.n_stages(); ++number) {
    const auto begin = std::chrono::steady_clock::now();
    exchange::Stage stage{.layer = 1, .in_equilibrium = true};
    for (std::size_t p = 0; p < points.size(); ++p) {
      const exchange::PathLeg& leg = legs[p][size_of(number - 1)];
      stage.linear_solves += run_leg(material.soil, leg, number, points[p]);
      stage.steps = std::max<std::int64_t>(stage.steps, leg.increments);
    }
    stage.points = samples_of(points, material, study.geometry.dimension);
    stage.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    sink(stage);
  }
}

} // namespace settle::mpm
