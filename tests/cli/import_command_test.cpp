#include <fmt/format.h>
#include <gmock/gmock.h>

#include "command_line.hpp"
#include "paper_cases.hpp"
#include "perfect_result.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// The perfect result of a case as a table, as another code would print it: nine digits.
class ImportCommand : public CommandLine {
protected:
  ImportCommand() { // without refilled mass, which the perfect result spreads over all points
    study = paper_case(4, exchange::Convention::drop);
    case_file = folder.file("dropped.toml", exchange::to_toml(study));
  }
  static constexpr const char* header =
      "stage,point,placed_x_m,placed_y_m,x_m,y_m,u_x_m,u_y_m,sigma_xx_kPa,sigma_yy_kPa,"
      "sigma_zz_kPa,sigma_xy_kPa,density_kg_m3,volume_m2,base_reaction_N_m,refilled\n";

  [[nodiscard]] std::string table() const {
    const exchange::Result result = perfect_result(study, exchange::Kinematics::finite, "mpm");
    std::string text = header;
    for (const exchange::Stage& stage : result.stages) {
      const exchange::SamplePoints& points = stage.points;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const auto two = [i](const std::vector<double>& values) {
          return fmt::format("{:.9g},{:.9g}", values[2 * i], values[2 * i + 1]);
        };
        const auto kilopascals = [&](std::size_t c) { return points.stress[6 * i + c] / 1e3; };
        text += fmt::format("{},{},{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{}\n", stage.layer,
                            points.id[i], two(points.placed_position), two(points.position), two(points.displacement),
                            kilopascals(0), kilopascals(1), kilopascals(2), kilopascals(3), points.density[i],
                            points.volume[i], stage.base_reaction, points.refilled[i]);
      }
    }
    return text;
  }
  [[nodiscard]] Answer import(const std::string& text) const {
    return settle({"import", "csv", folder.file("table.csv", text).string(), case_file.string(), "--out",
                   written().string(), "--solver", "theirs"});
  }
  [[nodiscard]] std::filesystem::path written() const { return folder.path() / "theirs.h5"; }
};

TEST_F(ImportCommand, ATableBecomesAResultThatMeetsTheExactSolution) {
  const Answer answer = import(table());
  ASSERT_EQ(answer.code, 0) << answer.text;
  const Answer norms = settle({"compare", written().string(), "exact", "--case",
                               folder
                                   .file("legs.toml", R"toml(
format = 1
gravity = 9.81
geometry = { shape = "column", height = 5.0, width = 0.125, dimension = 2 }
construction = { layers = 4, convention = "drop", material = "fill" }
[material.fill]
law = "rate"
youngs_modulus = 400e3
poissons_ratio = 0.25
density = 1720.0
[[check]]
quantity = "settlement"
between = ["theirs", "exact"]
norm = "linf"
stage = "all"
limit = 1e-7
[[check]]
quantity = "lateral-stress"
between = ["theirs", "exact"]
norm = "linf"
limit = 1e-7
[[check]]
quantity = "base-reaction"
between = ["theirs", "exact"]
limit = 1e-8
[[check]]
quantity = "mass"
between = ["theirs", "exact"]
limit = 1e-8
)toml")
                                   .string()});
  EXPECT_EQ(norms.code, 0) << norms.text; // its audits of mass and weight are among the verdicts
  EXPECT_THAT(norms.text, HasSubstr("theirs: mass of all points = mass"));
}

TEST_F(ImportCommand, AllMissingColumnsAreNamed) {
  std::string text = table();
  text.replace(text.find("sigma_zz_kPa"), 12, "another");
  text.replace(text.find("base_reaction_N_m"), 17, "something");
  const Answer answer = import(text);
  EXPECT_EQ(answer.code, 4);
  EXPECT_THAT(answer.text,
              AllOf(HasSubstr("the column \"sigma_zz_kPa\" is missing"), HasSubstr("\"base_reaction_N_m\"")));
  EXPECT_FALSE(std::filesystem::exists(written()));
}

TEST_F(ImportCommand, StagesThatAreMissingAndMassThatIsLostAreRefused) {
  const std::string text = table();
  const Answer cut = import(text.substr(0, text.find("\n4,") + 1));
  EXPECT_EQ(cut.code, 4);
  EXPECT_THAT(cut.text, HasSubstr("stage 4 has no points"));
  const std::string row =
      "1,0,0.1,0.1,0.1,0.1,0,0,0,-1,0,0,1720,0.01,100,0\n2,0,0.1,0.1,0.1,0.1,0,0,0,-1,0,0,1720,0.02,100,0\n";
  EXPECT_THAT(import(header + row).text, HasSubstr("point 0 does not keep its mass"));
}

TEST_F(ImportCommand, ATableThatIsNotThereIsExitCodeFour) {
  EXPECT_EQ(settle({"import", "csv", "/nowhere/t.csv", case_file.string(), "--out", written().string()}).code, 4);
  EXPECT_EQ(settle({"import", "csv"}).code, 2);
}

} // namespace
} // namespace settle::compare::test
