// Throughput of the explicit step: points, space, threads, phase by phase; and what the memory of the machine gives.

#include <cmath>
#include <cstdint>
#include <random>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "settle/mpm/explicit_step.hpp"
#include "settle/mpm/placement.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {
namespace {

constexpr double height = 5.0; ///< [m]

/// Points at the Gauss points of simplices, else two along each side.
template <class Space>
PointLayout<Space::dim> layout_of() {
  if constexpr (std::is_same_v<Space, TriangleSpace>) return triangle_layout();
  if constexpr (std::is_same_v<Space, TetrahedronSpace>) return tetrahedron_layout();
  return lattice_layout<Space::dim>(2);
}

/// A body of n squares along each side that fill the grid but for its uppermost row, as the paper's soil, on rollers.
template <class Space>
Body<Space> body_of(int n, StressIntegration integration) {
  GridBox<Space::dim> box{.counts = {}, .size = height / n};
  box.counts.fill(n);
  ++box.counts.back();
  const Space space(box);
  Body<Space> body{.space = space,
                   .points = {},
                   .layout = layout_of<Space>(),
                   .cells = {},
                   .fixed = oedometer_supports(space),
                   .lame = Lame::from(400e3, 0.25),
                   .density = 1720.0,
                   .integration = integration};
  body.points.has_domains = Space::has_domains;
  place_layer(body, {.layer = 1, .base = 0.0, .thickness = height});
  body.sort();
  return body;
}

/// Gives the points the velocity of a whirl around a level axis: they cross cells all the time.
template <class Space>
void stir(Body<Space>& body, double speed) {
  const double k = M_PI / height;
  auto& position = body.points.position;
  auto& velocity = body.points.velocity;
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    const double x = position.front()[p], y = position.back()[p];
    velocity.front()[p] = speed * std::sin(k * x) * std::cos(k * y);
    velocity.back()[p] = -speed * std::cos(k * x) * std::sin(k * y);
  }
}

/// One whole step, as a stage takes it: with the search of cells, sorting, damping and what refilling has to know.
template <class Space>
void advance(ExplicitStep<Space>& step) {
  step.scatter({});
  benchmark::DoNotOptimize(step.column_heights());
  const double dt = step.stable_time_step(0.9);
  benchmark::DoNotOptimize(step.accelerate(0.75));
  step.displace(dt, dt);
  step.move();
}

/// Arguments: squares along a side, threads.
template <class Space, StressIntegration integration>
void whole_step(benchmark::State& state) {
  auto body = body_of<Space>(static_cast<int>(state.range(0)), integration);
  ExplicitStep<Space> step(body, static_cast<int>(state.range(1)));
  for (auto _ : state)
    advance(step);
  const auto points = static_cast<double>(body.points.size());
  state.counters["points"] = points;
  state.counters["updates"] = benchmark::Counter(points, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["threads"] = static_cast<double>(state.range(1));
}

/// The same while about one point in a hundred crosses into another cell in a step.
template <class Space, StressIntegration integration>
void crossing_step(benchmark::State& state) {
  auto body = body_of<Space>(static_cast<int>(state.range(0)), integration);
  stir(body, 0.2);
  ExplicitStep<Space> step(body, static_cast<int>(state.range(1)));
  for (auto _ : state)
    advance(step);
  state.counters["updates"] =
      benchmark::Counter(static_cast<double>(body.points.size()), benchmark::Counter::kIsIterationInvariantRate);
}

enum Phase { scatter, nodes, move, sort };

/// Arguments: squares along a side, phase. What a point costs in one phase.
template <class Space, StressIntegration integration>
void one_phase(benchmark::State& state) {
  auto body = body_of<Space>(static_cast<int>(state.range(0)), integration);
  ExplicitStep<Space> step(body);
  for (int k = 0; k < 3; ++k)
    advance(step);
  step.gather();
  for (auto _ : state)
    switch (state.range(1)) {
    case scatter:
      step.scatter({});
      break;
    case nodes:
      step.accelerate(0.75);
      step.displace(0.0, 0.0);
      break;
    case move:
      step.move();
      break;
    default:
      state.PauseTiming();
      std::fill(body.points.cell.begin(), body.points.cell.end(), -1); // sorts again, into the order they are in
      state.ResumeTiming();
      body.sort();
    }
  state.counters["updates"] =
      benchmark::Counter(static_cast<double>(body.points.size()), benchmark::Counter::kIsIterationInvariantRate);
}

/// a = b + 3 c (McCalpin's STREAM triad), 24 bytes a number moved. Argument: threads.
void triad(benchmark::State& state) {
  constexpr std::size_t n = 10'000'000;
  const auto threads = static_cast<std::size_t>(state.range(0));
  std::vector<double> a(n, 0.0), b(n, 1.0), c(n, 2.0);
  const auto part = [&](std::size_t t) {
    for (std::size_t i = n * t / threads; i < n * (t + 1) / threads; ++i)
      a[i] = b[i] + 3.0 * c[i];
  };
  for (auto _ : state) {
    std::vector<std::jthread> others;
    for (std::size_t t = 1; t < threads; ++t)
      others.emplace_back(part, t);
    part(0);
    others.clear();
    benchmark::ClobberMemory();
  }
  state.counters["bytes"] = benchmark::Counter(24.0 * n, benchmark::Counter::kIsIterationInvariantRate);
}

/// Threads that are worth measuring here.
std::vector<std::int64_t> thread_counts() {
  std::vector<std::int64_t> counts;
  for (std::int64_t n = 1; n <= static_cast<std::int64_t>(std::max(1U, std::thread::hardware_concurrency())); n *= 2)
    counts.push_back(n);
  return counts;
}

constexpr auto mixed = StressIntegration::full_cells, by_points = StressIntegration::points;

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const std::int64_t side : {6, 13, 41, 129, 250, 408, 1290})
    for (const std::int64_t threads : thread_counts())
      benchmark->Args({side, threads});
  benchmark->ArgNames({"side", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
}
void one_size(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"side", "threads"})->Args({250, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
}
void solid_sizes(benchmark::internal::Benchmark* benchmark) {
  for (const std::int64_t side : {4, 12, 32, 64})
    for (const std::int64_t threads : thread_counts())
      benchmark->Args({side, threads});
  benchmark->ArgNames({"side", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
}
void one_solid_size(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"side", "threads"})->Args({32, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
}
template <int side>
void phases(benchmark::internal::Benchmark* benchmark) {
  for (const Phase phase : {scatter, nodes, move, sort})
    benchmark->Args({side, phase});
  benchmark->ArgNames({"side", "phase"})->Unit(benchmark::kMillisecond);
}

BENCHMARK(triad)
    ->ArgName("threads")
    ->Apply([](auto* benchmark) {
      for (const std::int64_t threads : thread_counts())
        benchmark->Arg(threads);
    }) -> UseRealTime();
BENCHMARK_TEMPLATE(whole_step, TriangleSpace, mixed)->Apply(sizes);
BENCHMARK_TEMPLATE(whole_step, QuadrilateralSpace, mixed)->Apply(sizes);
BENCHMARK_TEMPLATE(whole_step, BSplineSpace<2>, by_points)->Apply(sizes);
BENCHMARK_TEMPLATE(whole_step, QuadrilateralSpace, by_points)->Apply(one_size);
BENCHMARK_TEMPLATE(whole_step, BSplineSpace<2>, mixed)->Apply(one_size);
BENCHMARK_TEMPLATE(whole_step, GimpSpace<2>, by_points)->Apply(one_size);
BENCHMARK_TEMPLATE(whole_step, TetrahedronSpace, mixed)->Apply(solid_sizes);
BENCHMARK_TEMPLATE(whole_step, HexahedronSpace, by_points)->Apply(solid_sizes);
BENCHMARK_TEMPLATE(whole_step, BSplineSpace<3>, by_points)->Apply(solid_sizes);
BENCHMARK_TEMPLATE(whole_step, HexahedronSpace, mixed)->Apply(one_solid_size);
BENCHMARK_TEMPLATE(whole_step, BSplineSpace<3>, mixed)->Apply(one_solid_size);
BENCHMARK_TEMPLATE(crossing_step, TriangleSpace, mixed)->Apply(one_size);
BENCHMARK_TEMPLATE(crossing_step, QuadrilateralSpace, mixed)->Apply(one_size);
BENCHMARK_TEMPLATE(crossing_step, TetrahedronSpace, mixed)->Apply(one_solid_size);
BENCHMARK_TEMPLATE(crossing_step, HexahedronSpace, mixed)->Apply(one_solid_size);
BENCHMARK_TEMPLATE(one_phase, TriangleSpace, mixed)->Apply(phases<250>);
BENCHMARK_TEMPLATE(one_phase, QuadrilateralSpace, mixed)->Apply(phases<250>);
BENCHMARK_TEMPLATE(one_phase, BSplineSpace<2>, by_points)->Apply(phases<250>);
BENCHMARK_TEMPLATE(one_phase, TetrahedronSpace, mixed)->Apply(phases<32>);
BENCHMARK_TEMPLATE(one_phase, HexahedronSpace, by_points)->Apply(phases<32>);
BENCHMARK_TEMPLATE(one_phase, BSplineSpace<3>, by_points)->Apply(phases<32>);

} // namespace
} // namespace settle::mpm
