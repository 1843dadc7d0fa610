/// \file
/// How a lattice cuts a body into pieces, in the plane and in space: what is left of its cells, and what becomes of
/// slivers. What part of the body lies in a square or cube is told by a function.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "settle/mpm/polygon_fill.hpp"
#include "settle/mpm/square_grid.hpp"

namespace settle::mpm {

/// Cuts along a lattice; `PartIn`: the piece of the body in the square or cube (corner, size), of volume 0 if there is
/// none.
template <int dim, class PartIn>
class LatticeFill {
public:
  LatticeFill(const Lattice<dim>& lattice, PartIn part_in) : lattice_(lattice), part_in_(std::move(part_in)) {}

  /// Of a body within these bounds: cell by cell along x first, row by row from below.
  [[nodiscard]] std::vector<Piece<dim>> pieces(const Vector<dim>& lowest, const Vector<dim>& highest) const {
    std::vector<Piece<dim>> pieces, slivers;
    for (const Vector<dim>& cell : cells_around(lowest, highest)) {
      const Piece<dim> whole = part_in_(cell, lattice_.size);
      if (whole.volume <= negligible_share * volume_of(lattice_.size)) continue;
      if (whole.volume < smallest_share * volume_of(lattice_.spacing())) {
        slivers.push_back(whole);
        continue;
      }
      const std::vector<Piece<dim>> own = pieces_of_cell(cell, whole.volume);
      pieces.insert(pieces.end(), own.begin(), own.end());
    }
    if (pieces.empty()) return slivers;
    for (const Piece<dim>& sliver : slivers)
      nearest_to(sliver, pieces).volume += sliver.volume; // which stays in its own cell: none is left with one point
    return pieces;
  }

private:
  /// Of a full square of the lattice: what is smaller is joined to a neighbour.
  static constexpr double smallest_share = 1.0 / 3.0;
  /// Of a cell: what is smaller is round-off of the cutting.
  static constexpr double negligible_share = 1e-12;
  /// With fewer points a cell could deform without resistance. In space two rows of those in the plane.
  static constexpr std::size_t fewest_pieces = dim == 2 ? 3 : 6;
  static constexpr int finest_division = 8; ///< of a lattice square's side, for cells of which little is filled

  static double volume_of(double size) { return dim == 2 ? size * size : size * size * size; }

  static Piece<dim>& nearest_to(const Piece<dim>& part, std::vector<Piece<dim>>& pieces) {
    return *std::min_element(pieces.begin(), pieces.end(), [&](const Piece<dim>& a, const Piece<dim>& b) {
      return (a.centroid - part.centroid).squaredNorm() < (b.centroid - part.centroid).squaredNorm();
    });
  }

  /// Joins a part to the nearest piece of the same cell.
  static void join(const Piece<dim>& part, std::vector<Piece<dim>>& pieces) {
    Piece<dim>& nearest = nearest_to(part, pieces);
    nearest.volume += part.volume;
    nearest.centroid += part.volume / nearest.volume * (part.centroid - nearest.centroid);
  }

  /// Joins pieces smaller than `threshold` to larger ones; where there are none of these, all stay as they are.
  static std::vector<Piece<dim>> without_slivers(const std::vector<Piece<dim>>& parts, double threshold) {
    std::vector<Piece<dim>> pieces, slivers;
    for (const Piece<dim>& part : parts)
      (part.volume < threshold ? slivers : pieces).push_back(part);
    if (pieces.empty()) return parts;
    for (const Piece<dim>& sliver : slivers)
      join(sliver, pieces);
    return pieces;
  }

  static Vector<dim> offset(const BoxNumbering<dim>& box, int number) {
    Vector<dim> offset;
    for (std::size_t d = 0; d < dim; ++d)
      offset[static_cast<int>(d)] = box.index(number)[d];
    return offset;
  }

  /// Parts in the `per_side` squares along each axis of a cell.
  [[nodiscard]] std::vector<Piece<dim>> parts_in(const Vector<dim>& cell, int per_side) const {
    const double size = lattice_.size / per_side;
    BoxNumbering<dim> squares{};
    squares.counts.fill(per_side);
    std::vector<Piece<dim>> parts;
    for (int i = 0; i < squares.size(); ++i) {
      const Piece<dim> part = part_in_(Vector<dim>(cell + size * offset(squares, i)), size);
      if (part.volume > negligible_share * volume_of(lattice_.size)) parts.push_back(part);
    }
    return without_slivers(parts, smallest_share * volume_of(size));
  }

  [[nodiscard]] std::vector<Piece<dim>> pieces_of_cell(const Vector<dim>& cell, double volume) const {
    const bool full = volume > (1.0 - 1e-9) * volume_of(lattice_.size);
    std::vector<Piece<dim>> pieces = parts_in(cell, lattice_.per_side);
    for (int finer = 2; !full && pieces.size() < fewest_pieces && finer <= finest_division; finer *= 2)
      pieces = parts_in(cell, finer * lattice_.per_side);
    return pieces;
  }

  /// Corners of all cells around a body, those beside it too.
  [[nodiscard]] std::vector<Vector<dim>> cells_around(const Vector<dim>& lowest, const Vector<dim>& highest) const {
    BoxNumbering<dim> box{};
    Vector<dim> first;
    for (int d = 0; d < dim; ++d) {
      const auto index = [&](const Vector<dim>& x) { return std::floor((x[d] - lattice_.origin[d]) / lattice_.size); };
      first[d] = index(lowest);
      box.counts[static_cast<std::size_t>(d)] = static_cast<int>(index(highest) - first[d]) + 1;
    }
    std::vector<Vector<dim>> cells;
    for (int i = 0; i < box.size(); ++i)
      cells.push_back(lattice_.origin + lattice_.size * (first + offset(box, i)));
    return cells;
  }

  Lattice<dim> lattice_;
  PartIn part_in_;
};

} // namespace settle::mpm
