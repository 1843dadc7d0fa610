/// \file
/// The spaces of shape functions: what one offers, and the list of those there are. Everything that needs a space is a
/// template over it, instantiated in its .cpp file for every space of the list.
///
/// A space is a grid of cells with shape functions on it:
///
///     dim                         2 or 3
///     max_nodes                   nodes that all points of one cell can touch together
///     cells_per_square            cell c lies in square c / cells_per_square
///     has_constant_gradients      gradients are the same at all points of a cell
///     has_domains                 points have to carry their domains (Points::has_domains)
///     Stencil                     see stencil.hpp
///     columns() rows() size() origin() plan_area() corner(column, row) ...   the squares, see square_grid.hpp
///     n_cells() cell_volume() column_of(cell) row_of(cell) locate(x)         locate: -1 outside the grid
///     shortest_length()           [m], what the stable time step is measured with
///     n_nodes() node_numbering() node_position(node)
///     stencil(cell, points, p)    at point p of that cell; may use all that the points carry
///     cell_average(cell)          values and gradients of the cell's shape functions, averaged over its volume
#pragma once

#include "settle/mpm/domain_space.hpp"
#include "settle/mpm/product_space.hpp"
#include "settle/mpm/tetrahedron_space.hpp"
#include "settle/mpm/triangle_space.hpp"

/// Calls the macro X with every space of the plane.
#define SETTLE_FOR_EVERY_PLANE_SPACE(X)                                                                                \
  X(TriangleSpace)                                                                                                     \
  X(QuadrilateralSpace)                                                                                                \
  X(GimpSpace<2>)                                                                                                      \
  X(BSplineSpace<2>)                                                                                                   \
  X(BSplineGimpSpace<2>)

/// Calls the macro X with every space.
#define SETTLE_FOR_EVERY_SPACE(X)                                                                                      \
  SETTLE_FOR_EVERY_PLANE_SPACE(X)                                                                                      \
  X(TetrahedronSpace)                                                                                                  \
  X(HexahedronSpace)                                                                                                   \
  X(GimpSpace<3>)                                                                                                      \
  X(BSplineSpace<3>)                                                                                                   \
  X(BSplineGimpSpace<3>)
