/// \file
/// The comparator compares what nobody would: a result file that is perfect but for one thing, and what has to be said
/// of it. Each goes the whole way: written as a file, read, judged, turned into an exit code.

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include "paper_cases.hpp"
#include "perfect_result.hpp"
#include "scratch_folder.hpp"
#include "settle/compare/campaign_run.hpp"
#include "settle/compare/judge.hpp"
#include "settle/compare/solver_run.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;
using exchange::ExitCode;
using exchange::Quantity;
using exchange::Result;
using exchange::SamplePoints;
using testing::HasSubstr;

/// What is done to a perfect result, and what it then has to be.
struct Sabotage {
  std::string name;
  std::function<void(Result&)> of_the_numbers; ///< before the file is written
  std::function<void(hid_t)> of_the_file;      ///< after that
  Status status = Status::failed;              ///< the worst of all verdicts
  ExitCode code = ExitCode::verdict_failed;
  std::string word; ///< in the message of a verdict
};

std::ostream& operator<<(std::ostream& stream, const Sabotage& sabotage) {
  return stream << sabotage.name;
}

exchange::Check check_of(Quantity quantity, exchange::Over over) {
  exchange::Check check;
  check.quantity = quantity;
  check.between = {"mpm", "exact"};
  check.over = over;
  check.limit = 1e-9;
  return check;
}

exchange::Case study_of_all() {
  exchange::Case study = paper_case(3, exchange::Convention::refill);
  for (const exchange::Over over : {exchange::Over::points, exchange::Over::probes}) {
    study.checks.push_back(check_of(Quantity::settlement, over));
    study.checks.push_back(check_of(Quantity::vertical_stress, over));
  }
  return study;
}

/// The rows of an array of n points, in another order.
template <class T>
void permute(std::vector<T>& values, const std::vector<std::size_t>& order) {
  const std::size_t columns = values.size() / order.size();
  std::vector<T> moved;
  for (const std::size_t row : order)
    moved.insert(moved.end(), values.begin() + static_cast<std::ptrdiff_t>(row * columns),
                 values.begin() + static_cast<std::ptrdiff_t>((row + 1) * columns));
  values = std::move(moved);
}

void permute(SamplePoints& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  permute(points.id, order);
  permute(points.layer, order);
  permute(points.refilled, order);
  permute(points.placed_position, order);
  permute(points.position, order);
  permute(points.displacement, order);
  permute(points.stress, order);
  permute(points.density, order);
  permute(points.volume, order);
}

SamplePoints& last(Result& result) {
  return result.stages.back().points;
}

void scale(std::vector<double>& values, double factor) {
  for (double& value : values)
    value *= factor;
}

void remove(hid_t file, const char* name) {
  EXPECT_GE(H5Ldelete(file, name, H5P_DEFAULT), 0) << name;
}

/// The sum of another case in the place of the right one; both have 64 letters.
void set_case_hash(hid_t file) {
  const hid_t attribute = H5Aopen(file, "case_sha256", H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  const std::string other = exchange::sha256("another case");
  const char* text = other.c_str();
  EXPECT_GE(H5Awrite(attribute, type, H5Tis_variable_str(type) > 0 ? static_cast<const void*>(&text) : text), 0);
  H5Tclose(type);
  H5Aclose(attribute);
}

std::vector<Sabotage> all_sabotage() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto missing = [](std::string name, std::function<void(Result&)> spoil, std::string word) {
    return Sabotage{std::move(name), std::move(spoil), {}, Status::missing, ExitCode::file_failed, std::move(word)};
  };
  const auto failed = [](std::string name, std::function<void(Result&)> spoil, std::string word) {
    return Sabotage{std::move(name), std::move(spoil), {}, Status::failed, ExitCode::verdict_failed, std::move(word)};
  };
  const auto passed = [](std::string name, std::function<void(Result&)> change) {
    return Sabotage{std::move(name), std::move(change), {}, Status::passed, ExitCode::success, ""};
  };
  const auto unreadable = [](std::string name, std::function<void(hid_t)> damage, std::string word) {
    return Sabotage{std::move(name), {}, std::move(damage), Status::error, ExitCode::file_failed, std::move(word)};
  };
  return {
      passed("nothing", {}),
      passed("points permuted", [](Result& result) { permute(last(result)); }),
      missing(
          "NaN in a displacement", [](Result& result) { last(result).displacement[3] = nan; }, "NaN or infinite"),
      missing(
          "NaN in a stress", [](Result& result) { last(result).stress[1] = nan; }, "NaN or infinite"),
      missing(
          "+Inf in a displacement", [](Result& result) { last(result).displacement[3] = infinity; }, "infinite"),
      missing(
          "-Inf in a stress", [](Result& result) { last(result).stress[1] = -infinity; }, "infinite"),
      missing(
          "NaN in the base reaction", [](Result& result) { result.stages[1].base_reaction = nan; },
          "no value to judge"),
      missing(
          "NaN in a probe", [](Result& result) { result.stages.back().probes.begin()->second.stress[1] = nan; }, "NaN"),
      failed(
          "sign of displacement", [](Result& result) { scale(last(result).displacement, -1); }, "above the limit"),
      failed(
          "sign of stress", [](Result& result) { scale(last(result).stress, -1); }, "above the limit"),
      failed(
          "sign of probes", [](Result& result) { scale(result.stages.back().probes.begin()->second.stress, -1); },
          "above the limit"),
      failed(
          "layers swapped",
          [](Result& result) {
            for (int& layer : last(result).layer)
              layer = static_cast<int>(result.stages.size()) + 1 - layer;
          },
          "above the limit"),
      failed(
          "displacement in mm", [](Result& result) { scale(last(result).displacement, 1e3); }, "above the limit"),
      failed(
          "stress in kPa", [](Result& result) { scale(last(result).stress, 1e-3); }, "above the limit"),
      failed(
          "density in g/cm3", [](Result& result) { scale(last(result).density, 1e-3); }, "above the limit"),
      failed(
          "reaction in kN", [](Result& result) { result.stages.back().base_reaction *= 1e-3; }, "above the limit"),
      failed(
          "solved with another density", [](Result& result) { result.used.density *= 1.001; }, "density"),
      missing(
          "no points", [](Result& result) { last(result) = {}; }, "no points"),
      missing(
          "no stages", [](Result& result) { result.stages.clear(); }, ""),
      missing(
          "no probes", [](Result& result) { result.stages.back().probes.clear(); }, ""),
      unreadable(
          "no stresses", [](hid_t file) { remove(file, "/stages/0003/points/stress"); }, "stress"),
      unreadable(
          "no volumes", [](hid_t file) { remove(file, "/stages/0001/points/volume"); }, "volume"),
      unreadable(
          "no values used", [](hid_t file) { remove(file, "/used"); }, "used"),
      unreadable("hash of another case", set_case_hash, "case_sha256 does not belong"),
  };
}

class ComparatorSelfTest : public testing::TestWithParam<Sabotage> {
protected:
  /// A run whose MPM result was written, spoilt, and read.
  [[nodiscard]] RunOutcome run_after(const Sabotage& sabotage) const {
    RunOutcome run = perfect_run(study_of_all());
    run.solvers.erase(run.solvers.begin() + 1); // fem
    Result& result = result_in(run, "mpm");
    if (sabotage.of_the_numbers) sabotage.of_the_numbers(result);
    const fs::path file = folder_.path() / "mpm.h5";
    exchange::ResultWriter writer(file, run.study, "settle-mpm", result.used);
    for (const exchange::Stage& stage : result.stages)
      writer.write(stage);
    writer.finish(0.1, 1);
    if (sabotage.of_the_file) {
      const hid_t open = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
      sabotage.of_the_file(open);
      H5Fclose(open);
    }
    run.solvers.front() = stored_result("mpm", file);
    judge_into(run);
    return run;
  }

private:
  ScratchFolder folder_;
};

TEST_P(ComparatorSelfTest, GivesTheRightOutcome) {
  const Sabotage& sabotage = GetParam();
  const RunOutcome run = run_after(sabotage);
  std::string messages;
  for (const Verdict& verdict : run.verdicts)
    messages += verdict.what + ": " + verdict.message + "\n";
  EXPECT_EQ(worst(run.verdicts), sabotage.status) << messages;
  EXPECT_EQ(exit_code_of({run}), sabotage.code) << messages;
  EXPECT_THAT(messages, HasSubstr(sabotage.word));
}

INSTANTIATE_TEST_SUITE_P(Of, ComparatorSelfTest, testing::ValuesIn(all_sabotage()),
                         [](const testing::TestParamInfo<Sabotage>& each) {
                           std::string name = each.param.name;
                           std::replace_if(
                               name.begin(), name.end(), [](unsigned char letter) { return std::isalnum(letter) == 0; },
                               '_');
                           return name;
                         });

} // namespace
} // namespace settle::compare::test
