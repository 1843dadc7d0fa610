#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frozen_column.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::fem::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

fs::path fresh_folder(const std::string& name) {
  const fs::path folder = fs::path(::testing::TempDir()) / name;
  fs::remove_all(folder);
  return folder;
}

TEST(Pictures, ShowOnlyPlacedCellsAndListEveryStage) {
  const fs::path folder = fresh_folder("settle_fem_pictures");
  Solver(column({.layers = 2, .element_size = 0.5, .width = 0.5, .height = 2.0}))
      .build([](const exchange::Stage&) {}, folder);
  EXPECT_THAT(text_of(folder / "stage_0001.vtu"), HasSubstr("NumberOfCells=\"2\""));
  EXPECT_THAT(text_of(folder / "stage_0002.vtu"), HasSubstr("NumberOfCells=\"4\""));
  const std::string list = text_of(folder / "stages.pvd");
  EXPECT_THAT(list, HasSubstr("stage_0001.vtu"));
  EXPECT_THAT(list, HasSubstr("stage_0002.vtu"));
  for (const char* field : {"displacement", "layer", "stress_yy", "stress_zz"})
    EXPECT_THAT(text_of(folder / "stage_0002.vtu"), HasSubstr(field));
}

TEST(Pictures, AFileInPlaceOfTheFolderIsAFileError) {
  const fs::path taken = fresh_folder("settle_fem_taken");
  std::ofstream(taken) << "not a folder";
  const exchange::Case study = column({.layers = 1, .element_size = 0.5, .width = 0.5, .height = 1.0});
  EXPECT_THROW(Solver(study).build([](const exchange::Stage&) {}, taken), exchange::FileError);
}

} // namespace
} // namespace settle::fem::testing
