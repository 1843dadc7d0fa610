#include "polygon_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "embankment_mesh.hpp"
#include "polygon_outline.hpp"

namespace settle::fem {
namespace {

using exchange::PlanePoint;
using Nodes = std::vector<unsigned>; ///< vertices along a line

PlanePoint between(const PlanePoint& from, const PlanePoint& to, double share) {
  return {(1 - share) * from[0] + share * to[0], (1 - share) * from[1] + share * to[1]};
}

/// The four sides of a grid of cells, by its unit square: opposite sides run the same way.
struct Sides {
  Nodes bottom, right, top, left;
};

class MeshBuilder {
public:
  explicit MeshBuilder(const PolygonOutline& outline) : outline_(outline) { mesh_.vertices = outline.corners(); }

  void add_quadrilateral(const CornerNumbers& corners, int layer) {
    fill({.bottom = along_edge(corners[0], corners[1]),
          .right = along_edge(corners[1], corners[2]),
          .top = along_edge(corners[3], corners[2]),
          .left = along_edge(corners[0], corners[3])},
         layer);
  }

  void add_triangle(const CornerNumbers& corners, int layer) {
    const unsigned centroid = add_vertex(centroid_of(corners));
    const unsigned parts = outline_.parts(corners[0], corners[1]) / 2;
    const auto half = [&](unsigned from, unsigned to) {
      const Nodes whole = along_edge(from, to);
      return Nodes(whole.begin(), whole.begin() + parts + 1);
    };
    for (std::size_t c = 0; c < 3; ++c) {
      const Nodes forward = half(corners[c], corners[(c + 1) % 3]), back = half(corners[c], corners[(c + 2) % 3]);
      fill({.bottom = forward,
            .right = along(forward.back(), centroid, parts),
            .top = along(back.back(), centroid, parts),
            .left = back},
           layer);
    }
  }

  [[nodiscard]] PlaneMesh take() { return std::move(mesh_); }

private:
  unsigned add_vertex(const PlanePoint& position) {
    mesh_.vertices.push_back(position);
    return static_cast<unsigned>(mesh_.vertices.size() - 1);
  }

  [[nodiscard]] PlanePoint centroid_of(const CornerNumbers& corners) const {
    PlanePoint centroid{};
    for (const unsigned corner : corners)
      for (std::size_t d = 0; d < 2; ++d)
        centroid[d] += mesh_.vertices[corner][d] / static_cast<double>(corners.size());
    return centroid;
  }

  Nodes along_edge(unsigned from, unsigned to) { return along(from, to, outline_.parts(from, to)); }

  /// Made once for each line and shared by the grids on its two sides.
  Nodes along(unsigned from, unsigned to, unsigned parts) {
    const auto [low, high] = std::minmax(from, to);
    const auto [entry, is_new] = lines_.try_emplace({low, high});
    Nodes& nodes = entry->second;
    if (is_new) {
      nodes = {low};
      for (unsigned i = 1; i < parts; ++i)
        nodes.push_back(add_vertex(between(mesh_.vertices[low], mesh_.vertices[high], double(i) / parts)));
      nodes.push_back(high);
    }
    return from == low ? nodes : Nodes(nodes.rbegin(), nodes.rend());
  }

  /// Rows of cells from bottom to top. The position of a node is bilinear in its place in the grid.
  void fill(const Sides& sides, int layer) {
    const std::size_t rows = sides.left.size() - 1, columns = sides.bottom.size() - 1;
    Nodes lower = sides.bottom;
    for (std::size_t row = 1; row <= rows; ++row) {
      Nodes upper = sides.top;
      if (row < rows) {
        upper = {sides.left[row]};
        for (std::size_t i = 1; i < columns; ++i)
          upper.push_back(add_vertex(between(mesh_.vertices[sides.left[row]], mesh_.vertices[sides.right[row]],
                                             static_cast<double>(i) / static_cast<double>(columns))));
        upper.push_back(sides.right[row]);
      }
      for (std::size_t i = 0; i < columns; ++i)
        mesh_.cells.push_back({{lower[i], lower[i + 1], upper[i], upper[i + 1]}, layer});
      lower = std::move(upper);
    }
  }

  const PolygonOutline& outline_;
  PlaneMesh mesh_;
  std::map<std::pair<unsigned, unsigned>, Nodes> lines_; ///< by the numbers of their ends, ascending
};

/// The cells as they are.
PlaneMesh section_of(const exchange::Mesh& given) {
  PlaneMesh mesh;
  for (const std::array<double, 3>& node : given.nodes)
    mesh.vertices.push_back({node[0], node[1]});
  for (const exchange::MeshCell& cell : given.cells) {
    const auto& nodes = cell.nodes;
    mesh.cells.push_back({{nodes[0], nodes[1], nodes[3], nodes[2]}, cell.layer});
  }
  return mesh;
}

} // namespace

PlaneMesh mesh_polygons(const exchange::Case& study) {
  if (study.geometry.mesh) return section_of(*study.geometry.mesh);
  if (study.geometry.shape == exchange::Shape::embankment) return mesh_polygons(divided_embankment(study));
  const PolygonOutline outline(study);
  MeshBuilder builder(outline);
  for (std::size_t i = 0; i < outline.polygons().size(); ++i) {
    const CornerNumbers& corners = outline.polygons()[i];
    const int layer = study.geometry.polygons[i].layer;
    if (corners.size() == 3)
      builder.add_triangle(corners, layer);
    else
      builder.add_quadrilateral(corners, layer);
  }
  return builder.take();
}

unsigned slices_along_depth(const exchange::Case& study) {
  constexpr double round_off = 1e-6; // of a slice
  return static_cast<unsigned>(std::ceil(study.geometry.depth.value() / study.fem.element_size - round_off));
}

} // namespace settle::fem
