#include "sample_result.hpp"

#include <gtest/gtest.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/result_io.hpp"

using namespace settle::exchange;

namespace {

/// Numbers that never repeat within a stage.
class Counter {
public:
  explicit Counter(double first) : next_(first) {}
  double operator()() { return next_ += 1.0 / 3.0; }
  std::vector<double> many(std::size_t count) {
    std::vector<double> numbers(count);
    for (double& number : numbers)
      number = (*this)();
    return numbers;
  }

private:
  double next_;
};

} // namespace

std::filesystem::path fresh_path(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto folder =
      std::filesystem::path(testing::TempDir()) / "settle_results" / test->test_suite_name() / test->name();
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder / name;
}

Case sample_case(int dimension) {
  return parse_case(R"(
format = 1
gravity = 9.81
geometry = {shape = "column", height = 2, width = 0.5, dimension = 2}
material.fill = {law = "hencky", youngs_modulus = 4e5, poissons_ratio = 0.25, density = 1720}
construction = {layers = 2, convention = "drop", material = "fill"}
)",
                    "sample.toml", {"geometry.dimension=" + std::to_string(dimension)});
}

Stage sample_stage(int layer, int dimension) {
  const std::size_t n = 3 * static_cast<std::size_t>(layer), m = 2, dim = static_cast<std::size_t>(dimension);
  Counter next(layer * 1000.0);
  Stage stage{.layer = layer, .steps = 17 + layer, .linear_solves = 40 + layer, .in_equilibrium = layer == 1};
  for (double* number : {&stage.out_of_balance, &stage.mass, &stage.mass_placed, &stage.mass_refilled, &stage.weight,
                         &stage.base_reaction, &stage.surface_height, &stage.wall_time})
    *number = next();
  stage.points = {.placed_position = next.many(n * dim),
                  .position = next.many(n * dim),
                  .displacement = next.many(n * dim),
                  .stress = next.many(n * 6),
                  .density = next.many(n),
                  .volume = next.many(n)};
  for (std::size_t i = 0; i < n; ++i) {
    stage.points.id.push_back((std::uint64_t{1} << 40) + i);
    stage.points.layer.push_back(static_cast<std::int32_t>(i / 3) + 1);
    stage.points.refilled.push_back(i % 2);
  }
  if (layer == 2) { // what may be left out
    stage.points.plastic_strain = next.many(n);
    stage.points.preconsolidation_pressure = next.many(n);
    stage.support_reactions = next.many(3 * dim);
  }
  stage.probes["axis"] = {.layer = {1, 1},
                          .design_position = next.many(m * dim),
                          .placed_position = next.many(m * dim),
                          .displacement = next.many(m * dim),
                          .stress = next.many(m * 6)};
  return stage;
}

std::filesystem::path write_sample(const std::string& name, int dimension) {
  const std::filesystem::path file = fresh_path(name);
  const Case study = sample_case(dimension);
  ResultWriter writer(file, study, "settle-test", used_values(study, Kinematics::finite));
  for (const int layer : {1, 2})
    writer.write(sample_stage(layer, dimension));
  writer.finish(1.5, 2);
  return file;
}

std::string complaint_about(const std::filesystem::path& file) {
  try {
    static_cast<void>(read_result(file));
  } catch (const FileError& error) {
    EXPECT_EQ(error.code(), ExitCode::file_failed);
    return error.what();
  }
  return {};
}
