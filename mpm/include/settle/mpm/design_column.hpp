/// \file
/// The surface of what is drawn, column by column of squares: as designed, and as it is.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/mpm/square_grid.hpp"

namespace settle::mpm {

template <class Space>
struct Body;

/// What is designed over one column of squares.
struct DesignColumn {
  /// A part of the column, in plan as wide as points lie apart; heights in its middle [m].
  struct Strip {
    double top = 0;  ///< of the designed surface
    double foot = 0; ///< of the lower side of what is designed
  };

  double level = 0;                         ///< the grid's base, and designed volume over the column's area in plan [m]
  std::vector<std::optional<Strip>> strips; ///< along x first; empty where nothing is designed in their middle

  /// Adds what is there in the middle of a strip.
  void add(std::size_t strip, const Strip& there);
  /// Adds what is designed of another layer over the same column; `base`: of the grid [m].
  void add(const DesignColumn& layer, double base);
  /// Share of the plan over which something is designed.
  [[nodiscard]] double covered() const;
  /// Of the designed surface, where there is one [m].
  [[nodiscard]] double mean_top() const;
};

/// What is drawn of these layers, over every column of squares of a grid, `strips` of them along each horizontal axis.
/// Areas of polygons are exact. Of a body that varies along y the volume is that of the points placed over a column: as
/// placed, nothing is missing.
std::vector<DesignColumn> design_columns(const exchange::Geometry& geometry, const std::set<int>& layers,
                                         const GridBox<2>& grid, int strips);
std::vector<DesignColumn> design_columns(const exchange::Geometry& geometry, const std::set<int>& layers,
                                         const GridBox<3>& grid, int strips);

/// As `column_heights`, for material that moves sideways: a point's volume is shared by the columns over which it
/// extends, evenly. Half of what it extends along a horizontal axis is half the points' spacing, or the distance to the
/// nearer side of its column as it was placed where that is less: then all its volume was in its column [m].
template <class Space>
std::vector<double> extended_column_heights(const Body<Space>& body);

} // namespace settle::mpm
