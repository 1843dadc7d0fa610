#include "settle/compare/reference_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "paper_cases.hpp"
#include "scratch_folder.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::test {
namespace {

using exchange::Convention;
using exchange::FileError;
using testing::HasSubstr;

const std::string header = "stage,point,placed_y_m,y_m,u_y_m,sigma_xx_kPa,sigma_yy_kPa,density_kg_m3,volume_m2\n";

ReferenceTable read(const std::string& text, Convention convention = Convention::drop) {
  const ScratchFolder folder;
  return read_reference_table(folder.file("table.csv", text), paper_case(5, convention));
}

std::string error_of(const std::string& text) {
  try {
    read(text);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ReferenceTable, AveragesPointsAtOneHeightByVolumeAndConvertsUnits) {
  const ReferenceTable table =
      read(header + "1,1,0.5,0.49,-0.01,-1,-3,1700,0.001\n1,2,0.5,0.48,-0.02,-2,-6,1800,0.003\n");
  ASSERT_EQ(table.size(), 1U);
  EXPECT_EQ(table.points[0], 2);
  EXPECT_EQ(table.layer[0], 1);
  EXPECT_NEAR(table.settlement[0], 0.0175, 1e-15);
  EXPECT_NEAR(table.vertical_stress[0], -5250.0, 1e-9);
  EXPECT_NEAR(table.lateral_stress[0], -1750.0, 1e-9);
  EXPECT_NEAR(table.density[0], 1775.0, 1e-9);
  EXPECT_NEAR(table.volume[0], 0.004, 1e-15);
}

TEST(ReferenceTable, LayersAreThoseOfThePlacedHeightWherePlacedAtDesignLevel) {
  const ReferenceTable table = read(header + "3,1,0.02,0,0,0,0,1,1\n3,2,0.99,0,0,0,0,1,1\n3,3,2.01,0,0,0,0,1,1\n");
  EXPECT_EQ(table.layer, (std::vector<int>{1, 1, 3}));
}

TEST(ReferenceTable, LayersAreThoseOfTheFirstStageWherePlacedOnTheSurface) {
  const ReferenceTable table =
      read(header + "1,1,0.9,0,0,0,0,1,1\n2,1,0.9,0,0,0,0,1,1\n2,2,0.95,0,0,0,0,1,1\n", Convention::floating);
  EXPECT_EQ(table.stage, (std::vector<int>{1, 2, 2}));
  EXPECT_EQ(table.layer, (std::vector<int>{1, 1, 2}));
}

TEST(ReferenceTable, ColumnsMayStandInAnyOrderAndRefilledRowsAreLeftOut) {
  const ReferenceTable table =
      read("refilled,volume_m2,density_kg_m3,sigma_yy_kPa,sigma_xx_kPa,u_y_m,y_m,placed_y_m,"
           "point,stage\r\n0,1,1720,-3,-1,-0.1,0.4,0.5,1,1\r\n1,1,1720,-9,-9,-9,0.4,0.5,2,1\r\n");
  ASSERT_EQ(table.size(), 1U);
  EXPECT_EQ(table.points[0], 1);
  EXPECT_NEAR(table.vertical_stress[0], -3000.0, 1e-9);
}

TEST(ReferenceTable, ErrorsNameTheFileAndTheLine) {
  EXPECT_THAT(error_of("stage,point\n"), HasSubstr("the column \"placed_y_m\" is missing"));
  EXPECT_THAT(error_of(header + "1,1,0.5,0,0,0,0,1,1\n1,2,0.5,0,zero,0,0,1,1\n"),
              HasSubstr("table.csv:3: not a number"));
  EXPECT_THAT(error_of(header + "1,1,0.5\n"), HasSubstr("table.csv:2: 3 cells instead of 9"));
  EXPECT_THAT(error_of(header + "1,1,nan,0,0,0,0,1,1\n"), HasSubstr("not a number"));
  EXPECT_THAT(error_of(header), HasSubstr("no rows"));
  EXPECT_THAT(error_of(""), HasSubstr("is missing"));
}

TEST(ReferenceTable, APointAboveItsStageDoesNotBelongToTheCase) {
  EXPECT_THAT(error_of(header + "1,1,1.5,0,0,0,0,1,1\n"), HasSubstr("does not belong to this case"));
  EXPECT_THAT(error_of(header + "6,1,0.5,0,0,0,0,1,1\n"), HasSubstr("does not belong to this case"));
}

TEST(ReferenceTable, AFileThatIsNotThereIsAnError) {
  EXPECT_THROW(read_reference_table("/nowhere/table.csv", paper_case(5, Convention::drop)), FileError);
}

} // namespace
} // namespace settle::compare::test
