#include <cmath>
#include <fstream>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sample_result.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/result_io.hpp"

using namespace settle::exchange;
using testing::HasSubstr;

namespace {

void expect_same(const SamplePoints& read, const SamplePoints& written) {
  EXPECT_EQ(read.id, written.id);
  EXPECT_EQ(read.layer, written.layer);
  EXPECT_EQ(read.refilled, written.refilled);
  EXPECT_EQ(read.placed_position, written.placed_position);
  EXPECT_EQ(read.position, written.position);
  EXPECT_EQ(read.displacement, written.displacement);
  EXPECT_EQ(read.stress, written.stress);
  EXPECT_EQ(read.density, written.density);
  EXPECT_EQ(read.volume, written.volume);
  EXPECT_EQ(read.plastic_strain, written.plastic_strain);
  EXPECT_EQ(read.preconsolidation_pressure, written.preconsolidation_pressure);
}

void expect_same(const ProbeSamples& read, const ProbeSamples& written) {
  EXPECT_EQ(read.layer, written.layer);
  EXPECT_EQ(read.design_position, written.design_position);
  EXPECT_EQ(read.placed_position, written.placed_position);
  EXPECT_EQ(read.displacement, written.displacement);
  EXPECT_EQ(read.stress, written.stress);
}

void expect_same(const Stage& read, const Stage& written) {
  EXPECT_EQ(read.layer, written.layer);
  EXPECT_EQ(read.steps, written.steps);
  EXPECT_EQ(read.linear_solves, written.linear_solves);
  EXPECT_EQ(read.out_of_balance, written.out_of_balance);
  EXPECT_EQ(read.in_equilibrium, written.in_equilibrium);
  EXPECT_EQ(read.mass, written.mass);
  EXPECT_EQ(read.mass_placed, written.mass_placed);
  EXPECT_EQ(read.mass_refilled, written.mass_refilled);
  EXPECT_EQ(read.weight, written.weight);
  EXPECT_EQ(read.base_reaction, written.base_reaction);
  EXPECT_EQ(read.surface_height, written.surface_height);
  EXPECT_EQ(read.wall_time, written.wall_time);
  EXPECT_EQ(read.support_reactions, written.support_reactions);
  expect_same(read.points, written.points);
  ASSERT_EQ(read.probes.size(), written.probes.size());
  for (const auto& [name, samples] : written.probes)
    expect_same(read.probes.at(name), samples);
}

/// The message of the FileError that creating a writer throws; empty if it throws none.
std::string complaint_on_writing(const std::filesystem::path& file) {
  const Case study = sample_case(2);
  try {
    const ResultWriter writer(file, study, "settle-test", used_values(study, Kinematics::small));
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

/// A failure after which a solver went on, written after two stages of the sample case.
Failure sample_failure(int dimension) {
  return {.stage = 2,
          .share = 0.25,
          .run_out = RunOut{.at_rest = true,
                            .duration = 7.5,
                            .largest_displacement = 1.25,
                            .distance = 0.75,
                            .mass_before = 4321.0,
                            .points_before = 6,
                            .external_work = 100.5,
                            .stress_work = 90.25,
                            .damping_loss = 8.125,
                            .kinetic_energy = -0.5,
                            .state = sample_stage(2, dimension)}};
}

std::filesystem::path write_failed_sample(int dimension, const Failure& failure) {
  const std::filesystem::path file = fresh_path("failed.h5");
  ResultWriter writer(file, sample_case(dimension), "settle-test",
                      used_values(sample_case(dimension), Kinematics::finite));
  writer.write(sample_stage(1, dimension));
  writer.finish(1.5, 2, failure);
  return file;
}

class ResultRoundTrip : public testing::TestWithParam<int> {};

} // namespace

TEST_P(ResultRoundTrip, LosesNoBitOfAnyStage) {
  const Result result = read_result(write_sample("result.h5", GetParam()));
  ASSERT_EQ(result.stages.size(), 2U);
  for (const int layer : {1, 2})
    expect_same(result.stages[static_cast<std::size_t>(layer) - 1], sample_stage(layer, GetParam()));
}

TEST_P(ResultRoundTrip, KeepsAFailureAndWhatBecameOfTheBody) {
  const Failure written = sample_failure(GetParam());
  const Result result = read_result(write_failed_sample(GetParam(), written));
  ASSERT_TRUE(result.failure && result.failure->run_out);
  EXPECT_EQ(result.failure->stage, 2);
  EXPECT_EQ(result.failure->share, 0.25);
  const RunOut &read = *result.failure->run_out, &run_out = *written.run_out;
  EXPECT_EQ(read.at_rest, run_out.at_rest);
  EXPECT_EQ(read.duration, run_out.duration);
  EXPECT_EQ(read.largest_displacement, run_out.largest_displacement);
  EXPECT_EQ(read.distance, run_out.distance);
  EXPECT_EQ(read.mass_before, run_out.mass_before);
  EXPECT_EQ(read.points_before, run_out.points_before);
  EXPECT_EQ(read.external_work, run_out.external_work);
  EXPECT_EQ(read.stress_work, run_out.stress_work);
  EXPECT_EQ(read.damping_loss, run_out.damping_loss);
  EXPECT_EQ(read.kinetic_energy, run_out.kinetic_energy);
  EXPECT_EQ(read.unaccounted(), 100.5 - 90.25 - 8.125 + 0.5);
  expect_same(read.state, run_out.state);
}

TEST(ResultReader, RefusesARunOutWithNumbersThatCannotBe) {
  Failure failure = sample_failure(2);
  failure.run_out->distance = -0.5;
  EXPECT_THAT(complaint_about(write_failed_sample(2, failure)),
              AllOf(HasSubstr("/failure/run_out/distance is no such number"), HasSubstr("given:   -0.5"),
                    HasSubstr("allowed: a number from 0 on")));
  failure = sample_failure(2);
  failure.run_out->stress_work = std::nan("");
  EXPECT_THAT(complaint_about(write_failed_sample(2, failure)),
              HasSubstr("/failure/run_out/stress_work is no such number"));
}

TEST_P(ResultRoundTrip, KeepsTheCaseTheValuesUsedAndTheProvenance) {
  const Result result = read_result(write_sample("result.h5", GetParam()));
  EXPECT_EQ(result.case_text, to_toml(sample_case(GetParam())));
  EXPECT_EQ(result.used.youngs_modulus, 4e5);
  EXPECT_EQ(result.used.poissons_ratio, 0.25);
  EXPECT_EQ(result.used.density, 1720.0);
  EXPECT_EQ(result.used.gravity, 9.81);
  EXPECT_EQ(result.used.law, Law::hencky);
  EXPECT_EQ(result.used.kinematics, Kinematics::finite);
  EXPECT_EQ(result.used.convention, Convention::drop);
  EXPECT_EQ(result.used.dimension, GetParam());
  EXPECT_EQ(result.provenance.solver, "settle-test");
  EXPECT_EQ(result.provenance.program_version, program_version());
  EXPECT_EQ(result.provenance.commit, program_commit());
  EXPECT_EQ(result.provenance.case_sha256, sha256(result.case_text));
  EXPECT_EQ(result.provenance.threads, 2);
  EXPECT_EQ(result.provenance.wall_time, 1.5);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, ResultRoundTrip, testing::Values(2, 3),
                         [](const auto& parameter) { return "in" + std::to_string(parameter.param) + "D"; });

TEST(ResultWriter, KeepsAStageWithoutPointsOrProbes) {
  const auto file = fresh_path("empty.h5");
  const Case study = sample_case(2);
  ResultWriter writer(file, study, "settle-test", used_values(study, Kinematics::small));
  writer.write(Stage{.layer = 1});
  writer.finish(0, 1);
  const Result result = read_result(file);
  ASSERT_EQ(result.stages.size(), 1U);
  EXPECT_EQ(result.stages[0].points.size(), 0U);
  EXPECT_TRUE(result.stages[0].probes.empty());
}

TEST(ResultWriter, GivesTheFinalNameOnlyToAFileThatIsWhole) {
  const auto file = fresh_path("result.h5");
  const Case study = sample_case(2);
  ResultWriter writer(file, study, "settle-test", used_values(study, Kinematics::small));
  writer.write(sample_stage(1, 2));
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_TRUE(std::filesystem::exists(file.string() + ".partial"));
  writer.finish(0, 1);
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".partial"));
}

TEST(ResultWriter, ThatIsAbandonedLeavesAnOlderResultUntouched) {
  const auto file = write_sample("result.h5");
  const auto size = std::filesystem::file_size(file);
  {
    const Case study = sample_case(2);
    ResultWriter writer(file, study, "settle-other", used_values(study, Kinematics::small));
    writer.write(sample_stage(1, 2));
  }
  EXPECT_EQ(std::filesystem::file_size(file), size);
  EXPECT_EQ(read_result(file).provenance.solver, "settle-test");
  EXPECT_THAT(complaint_about(file.string() + ".partial"), HasSubstr("the result is not complete"));
}

TEST(ResultWriter, RefusesAStageWhoseVectorsDoNotBelongTogether) {
  const auto file = fresh_path("result.h5");
  const Case study = sample_case(2);
  ResultWriter writer(file, study, "settle-test", used_values(study, Kinematics::small));
  Stage stage = sample_stage(1, 2);
  stage.points.stress.pop_back();
  EXPECT_THROW(writer.write(stage), std::logic_error);
}

TEST(ResultWriter, SaysAtOnceThatItCannotWriteThere) {
  const auto file = fresh_path("file");
  std::ofstream(file) << "text";
  EXPECT_THAT(complaint_on_writing(file.parent_path() / "absent" / "r.h5"), HasSubstr("there is no such folder"));
  EXPECT_THAT(complaint_on_writing(file / "r.h5"), HasSubstr("there is no such folder"));
  EXPECT_THAT(complaint_on_writing(file.parent_path()), HasSubstr("given:   a folder"));
  std::filesystem::create_directory(file.parent_path() / "r.h5.partial");
  EXPECT_THAT(complaint_on_writing(file.parent_path() / "r.h5"), HasSubstr("the file cannot be created"));
}

/// As the daemon of MPI does, which inherits the open file of settle-fem and outlives it for a moment.
TEST(ResultReader, ReadsAFinishedFileThatAnotherProcessStillLocks) {
  const auto file = write_sample("result.h5");
  const int held = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(flock(held, LOCK_EX | LOCK_NB), 0);
  EXPECT_EQ(read_result(file).stages.size(), 2U);
  close(held);
}
