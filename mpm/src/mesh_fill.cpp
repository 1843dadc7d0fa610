#include "settle/mpm/mesh_fill.hpp"

#include <array>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "lattice_fill.hpp"
#include "settle/exchange/mesh_geometry.hpp"

namespace settle::mpm {
namespace {

using Tetrahedron = std::array<Vector<3>, 4>;
using Square = std::array<int, 3>; ///< a cell of the lattice

double volume_of(const Tetrahedron& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]).dot(t[3] - t[0]) / 6.0;
}

/// Below a level along an axis, or above it.
struct HalfSpace {
  int axis;
  double sign, level;

  [[nodiscard]] double depth(const Vector<3>& x) const { return sign * (x[axis] - level); }
};

/// Adds the part of a tetrahedron within a half space, as tetrahedra that run the same way.
void cut(const Tetrahedron& whole, const HalfSpace& half, std::vector<Tetrahedron>& parts) {
  std::vector<std::size_t> in, out;
  for (std::size_t c = 0; c < 4; ++c)
    (half.depth(whole[c]) >= 0.0 ? in : out).push_back(c);
  const auto between = [&](std::size_t a, std::size_t b) -> Vector<3> {
    const double depth = half.depth(whole[a]);
    return whole[a] + depth / (depth - half.depth(whole[b])) * (whole[b] - whole[a]);
  };
  const auto add = [&](Tetrahedron part) {
    if (volume_of(part) < 0.0) std::swap(part[2], part[3]);
    parts.push_back(std::move(part));
  };
  const auto add_prism = [&](const std::array<Vector<3>, 3>& low, const std::array<Vector<3>, 3>& high) {
    add({low[0], low[1], low[2], high[0]});
    add({low[1], low[2], high[0], high[1]});
    add({low[2], high[0], high[1], high[2]});
  };
  if (out.empty()) return parts.push_back(whole);
  if (in.size() == 1)
    add({whole[in[0]], between(in[0], out[0]), between(in[0], out[1]), between(in[0], out[2])});
  else if (in.size() == 2)
    add_prism({whole[in[0]], between(in[0], out[0]), between(in[0], out[1])},
              {whole[in[1]], between(in[1], out[0]), between(in[1], out[1])});
  else if (in.size() == 3)
    add_prism({whole[in[0]], whole[in[1]], whole[in[2]]},
              {between(in[0], out[0]), between(in[1], out[0]), between(in[2], out[0])});
}

/// The tetrahedra of a layer, by the cells of the lattice that they may reach into.
class Pieces {
public:
  Pieces(const exchange::Mesh& mesh, int layer, const Lattice<3>& lattice) : lattice_(lattice) {
    for (const exchange::MeshCell& cell : mesh.cells)
      if (cell.layer == layer)
        for (const auto& corners : exchange::tetrahedra_of(mesh, cell)) {
          Tetrahedron tetrahedron;
          for (std::size_t c = 0; c < 4; ++c)
            tetrahedron[c] = {corners[c][0], corners[c][1], corners[c][2]};
          add(tetrahedron);
        }
  }

  [[nodiscard]] const Vector<3>& lowest() const { return lowest_; }
  [[nodiscard]] const Vector<3>& highest() const { return highest_; }

  [[nodiscard]] Piece<3> part_in(const Vector<3>& corner, double size) const {
    Piece<3> part{Vector<3>::Zero(), 0.0};
    const auto near = by_square_.find(square_of(corner + Vector<3>::Constant(0.5 * size)));
    if (near == by_square_.end()) return part;
    for (const Tetrahedron& whole : near->second)
      for (const Tetrahedron& inside : within(whole, corner, size)) {
        const double volume = volume_of(inside);
        part.volume += volume;
        part.centroid += volume / 4.0 * (inside[0] + inside[1] + inside[2] + inside[3]);
      }
    if (part.volume > 0) part.centroid /= part.volume;
    return part;
  }

private:
  [[nodiscard]] Square square_of(const Vector<3>& x) const {
    Square square{};
    for (int d = 0; d < 3; ++d)
      square[static_cast<std::size_t>(d)] = static_cast<int>(std::floor((x[d] - lattice_.origin[d]) / lattice_.size));
    return square;
  }

  void add(const Tetrahedron& tetrahedron) {
    Vector<3> low = tetrahedron[0], high = tetrahedron[0];
    for (const Vector<3>& corner : tetrahedron)
      low = low.cwiseMin(corner), high = high.cwiseMax(corner);
    lowest_ = lowest_.cwiseMin(low), highest_ = highest_.cwiseMax(high);
    const Square first = square_of(low), last = square_of(high);
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i)
          by_square_[{i, j, k}].push_back(tetrahedron);
  }

  static std::vector<Tetrahedron> within(const Tetrahedron& whole, const Vector<3>& corner, double size) {
    std::vector<Tetrahedron> parts{whole}, next;
    for (int axis = 0; axis < 3; ++axis)
      for (const HalfSpace& half : {HalfSpace{axis, 1.0, corner[axis]}, HalfSpace{axis, -1.0, corner[axis] + size}}) {
        next.clear();
        for (const Tetrahedron& part : parts)
          cut(part, half, next);
        parts.swap(next);
      }
    return parts;
  }

  Lattice<3> lattice_;
  std::map<Square, std::vector<Tetrahedron>> by_square_;
  Vector<3> lowest_ = Vector<3>::Constant(HUGE_VAL), highest_ = Vector<3>::Constant(-HUGE_VAL);
};

} // namespace

std::vector<Piece<3>> cut_mesh(const exchange::Mesh& mesh, int layer, const Lattice<3>& lattice) {
  const Pieces pieces(mesh, layer, lattice);
  const LatticeFill fill(lattice, [&](const Vector<3>& corner, double size) { return pieces.part_in(corner, size); });
  return fill.pieces(pieces.lowest(), pieces.highest());
}

} // namespace settle::mpm
