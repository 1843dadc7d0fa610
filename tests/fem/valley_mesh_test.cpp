#include "valley_mesh.hpp"

#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <gtest/gtest.h>

#include "dams.hpp"
#include "mesh.hpp"
#include "settle/exchange/valley.hpp"
#include "settle/fem/requirements.hpp"

namespace settle::fem::testing {
namespace {

/// [m3], and the least of any cell's corner.
struct Volumes {
  std::map<int, double> of_layer{};
  double least_jacobian = 1e300;
};

Volumes volumes_of(const dealii::Triangulation<3>& mesh) {
  Volumes volumes;
  const dealii::FE_Q<3> element(1);
  const dealii::QGauss<3> quadrature(3);
  const dealii::QTrapezoid<3> corners;
  dealii::FEValues<3> inside(element, quadrature, dealii::update_JxW_values);
  dealii::FEValues<3> at_corners(element, corners, dealii::update_jacobians);
  for (const auto& cell : mesh.active_cell_iterators()) {
    inside.reinit(cell);
    at_corners.reinit(cell);
    const auto& weights = inside.get_JxW_values();
    volumes.of_layer[layer_of(cell)] += std::accumulate(weights.begin(), weights.end(), 0.0);
    for (const unsigned v : cell->vertex_indices())
      volumes.least_jacobian = std::min(volumes.least_jacobian, at_corners.jacobian(v).determinant());
  }
  return volumes;
}

/// Valleys with and without a floor, with flanks that lean and that do not.
TEST(ValleyMesh, FillsEveryLayerWithCellsThatAreNowhereDegenerate) {
  for (const char* valley : {"{ bottom = 1.0, slopes = [1.0, 0.6] }", "{ bottom = 0.0, slopes = [1.0, 0.6] }",
                             "{ bottom = 0.0, slopes = [0.0, 2.0] }", "{ bottom = 2.0, slopes = [0.0, 0.0] }"}) {
    const exchange::Case study = dam({}, {std::string("geometry.valley=") + valley});
    dealii::Triangulation<3> mesh;
    make_mesh(study, mesh);
    const Volumes volumes = volumes_of(mesh);
    EXPECT_GT(volumes.least_jacobian, 0.0) << valley;
    EXPECT_EQ(mesh.n_active_cells(), number_of_cells(study));
    for (int layer = 1; layer <= 3; ++layer) {
      const double volume = exchange::layer_volume(study.geometry, layer);
      EXPECT_NEAR(volumes.of_layer.at(layer), volume, 1e-12 * volume) << valley;
    }
  }
}

/// Each outer face lies on one of six planes, so that no crack runs between cells.
TEST(ValleyMesh, IsBoundedByFloorFlanksSlopesAndCrest) {
  const exchange::Case study = dam();
  dealii::Triangulation<3> mesh;
  make_mesh(study, mesh);
  for (const auto& face : mesh.active_face_iterators()) {
    if (!face->at_boundary()) continue;
    const dealii::Point<3> center = face->center();
    const exchange::Span x = exchange::fill_at(*study.geometry.embankment, center[2]);
    const exchange::Span y = exchange::valley_at(*study.geometry.valley, center[2]);
    const double off = std::min({std::abs(center[0] - x.from), std::abs(center[0] - x.to), std::abs(center[1] - y.from),
                                 std::abs(center[1] - y.to), std::abs(center[2]), std::abs(center[2] - 3.0)});
    EXPECT_LT(off, 1e-12);
  }
}

TEST(ValleyMesh, IsDividedInHalvesWhereTheSizeIsHalved) {
  const auto cells = [](double size) {
    return number_of_cells(dam({.element_size = size}, {"geometry.valley.bottom=2.0"}));
  };
  EXPECT_EQ(cells(0.25), 8 * cells(0.5));
}

TEST(ValleyMesh, HasNoMoreVerticesThanItsCellsShare) {
  dealii::Triangulation<3> mesh;
  make_mesh(dam({}, {"geometry.valley.bottom=0.0"}), mesh);
  std::set<std::array<long, 3>> places;
  for (const dealii::Point<3>& vertex : mesh.get_vertices())
    places.insert({std::lround(vertex[0] * 1e9), std::lround(vertex[1] * 1e9), std::lround(vertex[2] * 1e9)});
  EXPECT_EQ(places.size(), mesh.n_used_vertices());
}

} // namespace
} // namespace settle::fem::testing
