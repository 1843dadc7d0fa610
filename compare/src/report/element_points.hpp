/// \file
/// Finite elements told from their quadrature points (docs/fem.md: listed element by element, id = element x points of
/// an element + point, in the order of a tensor product of Gauss points). Positions and displacements of an element are
/// polynomials of the degree of its shape functions, so that its Gauss points say where its corners are.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "settle/exchange/plane_geometry.hpp"
#include "settle/exchange/result.hpp"

namespace settle::compare::report {

/// The quadrilateral of an element that one of its quadrature points stands for.
using Quadrilateral = std::array<exchange::PlanePoint, 4>;

/// Quadrature points along each edge of the elements of a case.
int points_along_edge(const exchange::Case& study);

/// Do the points come in elements of so many along each edge, in the plane?
bool come_in_elements(const exchange::SamplePoints& points, int along_edge);

/// What each quadrature point stands for, corners around it: its element, divided where the weights of the points
/// before it sum up to. `positions`: (n, 2) of all points [m]; they come in elements.
std::vector<Quadrilateral> parts_of_elements(const std::vector<double>& positions, int along_edge);

/// A field between the quadrature points of elements, each for itself.
class ElementField {
public:
  /// `positions`: (n, 2) of points that come in elements, which have straight edges there [m]; layer and value: (n).
  ElementField(const std::vector<double>& positions, const std::vector<int>& layer, std::vector<double> value,
               int along_edge);

  /// The value at a point of a layer, from an element that holds it; nothing where none does.
  [[nodiscard]] std::optional<double> at(int layer, const exchange::PlanePoint& point) const;

private:
  struct Element {
    int layer;
    Quadrilateral corners; ///< in the order of unit coordinates: 00, 10, 01, 11
    exchange::PlaneBox box;
  };
  int along_edge_;
  std::vector<double> value_;
  std::vector<Element> elements_;
};

} // namespace settle::compare::report
