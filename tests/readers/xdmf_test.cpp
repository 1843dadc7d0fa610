// The XDMF files that stand beside results, read by libxdmf, against the results themselves.
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <XdmfAttribute.hpp>
#include <XdmfDomain.hpp>
#include <XdmfGeometry.hpp>
#include <XdmfGeometryType.hpp>
#include <XdmfGridCollection.hpp>
#include <XdmfGridCollectionType.hpp>
#include <XdmfReader.hpp>
#include <XdmfTime.hpp>
#include <XdmfTopology.hpp>
#include <XdmfTopologyType.hpp>
#include <XdmfUnstructuredGrid.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "settle/exchange/result_io.hpp"

namespace settle::exchange {
namespace {

namespace fs = std::filesystem;

const std::vector<fs::path> solvers{SETTLE_SOLVERS};
const std::string study = SETTLE_CASES "/paper/refill.toml";

const std::string solid = " --set geometry.dimension=3 --set geometry.width=0.5 --set fem.element_size=0.5 "
                          "--set mpm.element_size=0.5 --set mpm.element=hexahedron --set mpm.points_per_element=8";

bool succeeds(const fs::path& solver, const std::string& options) {
  return std::system(fmt::format("'{}' '{}' {}", solver.string(), study, options).c_str()) == 0;
}

/// Where the solver has written its result of the case: a folder without blanks, which libxdmf cannot resolve.
fs::path result_of(const fs::path& solver, const std::string& name, const std::string& options) {
  const fs::path folder = fs::path(testing::TempDir()) / fmt::format("xdmf_{}_{}", solver.filename().string(), name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  const fs::path file = folder / "result.h5";
  EXPECT_TRUE(succeeds(solver, fmt::format("--quiet --out '{}' {}", file.string(), options)));
  return file;
}

shared_ptr<XdmfGridCollection> read_by_libxdmf(fs::path result) {
  const auto domain =
      shared_dynamic_cast<XdmfDomain>(XdmfReader::New()->read(result.replace_extension(".xdmf").string()));
  return domain != nullptr && domain->getNumberGridCollections() == 1 ? domain->getGridCollection(0) : nullptr;
}

template <class T>
std::vector<T> numbers(XdmfArray& array) {
  array.read();
  std::vector<T> values(array.getSize());
  if (!values.empty()) array.getValues<T>(0, values.data(), static_cast<unsigned>(values.size()));
  return values;
}

template <class T>
void expect_attribute(XdmfUnstructuredGrid& grid, const std::string& name, const std::vector<T>& wanted) {
  const auto attribute = grid.getAttribute(name);
  ASSERT_NE(attribute, nullptr) << name;
  EXPECT_EQ(numbers<T>(*attribute), wanted) << name;
}

void expect_points(XdmfUnstructuredGrid& grid, const SamplePoints& points, int dimension) {
  EXPECT_EQ(grid.getTopology()->getType(), XdmfTopologyType::Polyvertex());
  EXPECT_EQ(grid.getTopology()->getNumberElements(), points.size());
  EXPECT_EQ(grid.getGeometry()->getType(), dimension == 2 ? XdmfGeometryType::XY() : XdmfGeometryType::XYZ());
  EXPECT_EQ(numbers<double>(*grid.getGeometry()), points.position);
  EXPECT_EQ(grid.getNumberAttributes(), 6U);
  expect_attribute(grid, "displacement", points.displacement);
  expect_attribute(grid, "stress", points.stress);
  expect_attribute(grid, "density", points.density);
  expect_attribute(grid, "volume", points.volume);
  expect_attribute(grid, "layer", points.layer);
  expect_attribute(grid, "refilled", points.refilled);
}

/// Bit for bit: both read the same numbers, the one by our description of them.
void expect_same_numbers(const fs::path& file, int dimension) {
  const auto collection = read_by_libxdmf(file);
  ASSERT_NE(collection, nullptr);
  const Result result = read_result(file);
  EXPECT_EQ(collection->getType(), XdmfGridCollectionType::Temporal());
  ASSERT_GT(result.stages.size(), 1U);
  ASSERT_EQ(collection->getNumberUnstructuredGrids(), result.stages.size());
  for (unsigned stage = 0; stage < result.stages.size(); ++stage) {
    const auto grid = collection->getUnstructuredGrid(stage);
    EXPECT_EQ(grid->getTime()->getValue(), stage + 1.0);
    expect_points(*grid, result.stages[stage].points, dimension);
  }
}

class XdmfOf : public testing::TestWithParam<fs::path> {};

TEST_P(XdmfOf, ShowsEveryPointOfEveryStageToLibxdmf) {
  expect_same_numbers(result_of(GetParam(), "plane", ""), 2);
}

TEST_P(XdmfOf, ShowsTheColumnInThreeDimensions) {
  expect_same_numbers(result_of(GetParam(), "solid", solid), 3);
}

INSTANTIATE_TEST_SUITE_P(Solvers, XdmfOf, testing::ValuesIn(solvers), [](const auto& solver) {
  return solver.param.filename().string().substr(std::string("settle-").size());
});

} // namespace
} // namespace settle::exchange
