/// \file
/// Places and volumes in a mesh of hexahedra.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// x, y, z [m]
using SolidPoint = std::array<double, 3>;

/// The smallest upright box around a mesh.
struct SolidBox {
  SolidPoint lowest{}, highest{}; ///< [m]
};
SolidBox bounding_box(const Mesh& mesh);

/// Tetrahedra that make up a hexahedron, from its middle to each of its sides, which the middle of a side divides into
/// four triangles. Their volume is that of the trilinear cell (Grandy 1997, LLNL UCRL-ID-128886), and cells that share
/// a side divide it alike.
std::array<std::array<SolidPoint, 4>, 24> tetrahedra_of(const Mesh& mesh, const MeshCell& cell);

/// Of a hexahedron [m3].
double volume(const Mesh& mesh, const MeshCell& cell);

/// Of a layer of hexahedra [m3].
double layer_volume(const Mesh& mesh, int layer);

/// The layers whose cells, trilinear between their nodes, hold the point, not further than `slack` outside [m]; several
/// on an interface; ascending.
std::vector<int> layers_at(const Mesh& mesh, const SolidPoint& point, double slack);

/// Where a vertical line meets a side of a hexahedron, divided around its middle [m]; nothing where it does not, and
/// where the side is upright.
std::optional<double> height_of_side(const Mesh& mesh, const std::vector<unsigned>& side, double x, double y);

/// What one layer of hexahedra fills.
class LayerOfMesh {
public:
  /// The mesh has to outlive this.
  LayerOfMesh(const Mesh& mesh, int layer);

  [[nodiscard]] const SolidBox& box() const { return box_; }
  /// Where a vertical line meets the layer first, from below [m]; nothing where it does not.
  [[nodiscard]] std::optional<double> lower_side(double x, double y) const;
  /// The same from above.
  [[nodiscard]] std::optional<double> upper_side(double x, double y) const;

private:
  /// Where a vertical line meets its sides [m].
  [[nodiscard]] std::vector<double> heights_at(double x, double y) const;

  SolidBox box_;
  const Mesh& mesh_;
  std::vector<std::vector<unsigned>> surface_; ///< its sides
};

} // namespace settle::exchange
