// Every motion that a case under cases/ states as exact is proved here, formula by formula, before a solver is held
// against it.
#include "motion_proof.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/document.hpp"

namespace settle::compare::test {
namespace {

namespace fs = std::filesystem;
using exchange::Case;

/// Differences of fourth order leave 1e-8 of a value; the bar's strains are 1e-6, by which its linear formulas and the
/// case's law differ. A formula wrong by one percent is a hundred times as far off, or more.
constexpr double tolerance = 1e-5;

const fs::path cases_folder = fs::path(SETTLE_SOURCE_DIR) / "cases";

/// Stress of a soil depends on the way and not on the displacement alone, and its motion drives supports only.
bool yields(exchange::Law law) {
  return law > exchange::Law::neo_hookean;
}

std::vector<std::string> cases_with_a_motion() {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(cases_folder)) {
    if (entry.path().extension() != ".toml") continue;
    if (exchange::document::find(exchange::document::read(entry.path()), "motion") == nullptr) continue;
    if (!yields(exchange::read_case(entry.path()).fill().law))
      files.push_back(fs::relative(entry.path(), cases_folder).string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string name_of_test(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param.substr(0, info.param.size() - std::string(".toml").size());
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

bool holds(const std::vector<Finding>& findings) {
  return std::all_of(findings.begin(), findings.end(), [](const Finding& found) { return found.error <= tolerance; });
}

/// The case with one formula after the other taken for something else; constants have no sign to get wrong.
std::vector<Case> slips_of(const Case& study, const std::string& before, const std::string& after) {
  constexpr std::array lists{&exchange::Motion::displacement, &exchange::Motion::stress, &exchange::Motion::velocity,
                             &exchange::Motion::acceleration, &exchange::Motion::body_force};
  std::vector<Case> slips;
  for (const auto list : lists) {
    for (std::size_t i = 0; i < ((*study.motion).*list).size(); ++i) {
      if (((*study.motion).*list)[i] == "0") continue;
      Case& slip = slips.emplace_back(study);
      std::string& formula = ((*slip.motion).*list)[i];
      formula = before + formula + after;
    }
  }
  return slips;
}

class Motions : public testing::TestWithParam<std::string> {
protected:
  const Case study_ = exchange::read_case(cases_folder / GetParam());

  void expect_slips_caught(const std::vector<Case>& slips) const {
    constexpr int points = 60; // some on every edge of every layer
    EXPECT_THAT(slips, testing::Not(testing::IsEmpty()));
    for (const Case& slip : slips)
      EXPECT_FALSE(holds(prove(slip, points)))
          << exchange::to_toml(slip).substr(exchange::to_toml(slip).find("[motion]"));
  }
};

} // namespace

TEST_P(Motions, ObeyTheirLawAndMomentumBalanceAndTheBoundary) {
  constexpr int points = 400;
  const std::vector<Finding> findings = prove(study_, points);
  EXPECT_THAT(findings, testing::Contains(testing::Field(&Finding::what, testing::AnyOf(free_faces, held))));
  for (const Finding& found : findings) {
    EXPECT_LE(found.error, tolerance) << found.what;
    EXPECT_GE(found.compared, points / 50) << found.what;
    EXPECT_LE(found.dropped, points / 10) << found.what;
  }
}

TEST_P(Motions, AreNotProvedWithAWrongSignInAnyFormula) {
  expect_slips_caught(slips_of(study_, "-(", ")"));
}

TEST_P(Motions, AreNotProvedWithAnyFormulaOnePercentTooLarge) {
  expect_slips_caught(slips_of(study_, "1.01 * (", ")"));
}

INSTANTIATE_TEST_SUITE_P(Cases, Motions, testing::ValuesIn(cases_with_a_motion()), name_of_test);

TEST(MotionCases, AreAllFound) {
  std::set<std::string> folders;
  for (const std::string& file : cases_with_a_motion())
    folders.insert(fs::path(file).parent_path().string());
  EXPECT_THAT(folders, testing::IsSupersetOf({"compression", "manufactured", "slope", "vibration", "vortex", "wedge"}));
}

} // namespace settle::compare::test
