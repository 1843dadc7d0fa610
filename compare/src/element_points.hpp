/// \file
/// Finite elements told from their quadrature points (docs/fem.md: listed element by element, id = element x points of
/// an element + point, in the order of a tensor product of Gauss points). Positions and displacements of an element are
/// polynomials of the degree of its shape functions, so that its Gauss points say where its corners are.
#pragma once

#include <array>
#include <vector>

#include "settle/exchange/plane_geometry.hpp"
#include "settle/exchange/result.hpp"

namespace settle::compare {

/// The quadrilateral of an element that one of its quadrature points stands for.
using Quadrilateral = std::array<exchange::PlanePoint, 4>;

/// Quadrature points along each edge of the elements of a case.
int points_along_edge(const exchange::Case& study);

/// Do the points come in elements of so many along each edge, in the plane?
bool come_in_elements(const exchange::SamplePoints& points, int along_edge);

/// The corners of an element: at unit coordinates 00, 10, 01, 11.
using UnitCorners = std::array<exchange::PlanePoint, 4>;

/// Of the element that the points from `first` on belong to. `positions`: (n, 2) of points that come in elements [m].
UnitCorners corners_of_element(const std::vector<double>& positions, std::size_t first, int along_edge);

/// The polynomial through the values of an element's points, at unit coordinates. `values`: (n, c) of points that come
/// in elements; the result has c components.
std::vector<double> value_in_element(const std::vector<double>& values, std::size_t components, std::size_t first,
                                     int along_edge, const exchange::PlanePoint& unit);

/// What each quadrature point stands for, corners around it: its element, divided where the weights of the points
/// before it sum up to. `positions`: (n, 2) of all points [m]; they come in elements.
std::vector<Quadrilateral> parts_of_elements(const std::vector<double>& positions, int along_edge);

} // namespace settle::compare
