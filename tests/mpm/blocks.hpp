/// \file
/// Small bodies for tests of single phases.
#pragma once

#include <random>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "settle/mpm/body.hpp"
#include "settle/mpm/placement.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm::test {

/// A body of squares, or cubes, of 0.5 m, filled from below.
struct Block {
  int columns = 3;
  int deep = 2; ///< columns along y, in 3-D only
  int rows = 4;
  int filled_rows = 3;
  double size = 0.5;     ///< [m]
  bool supported = true; ///< rollers on all sides and the base; otherwise free
};

inline constexpr double block_density = 1800.0; ///< [kg/m3]

/// Every space, for typed tests.
using EverySpace =
    testing::Types<TriangleSpace, QuadrilateralSpace, GimpSpace<2>, BSplineSpace<2>, TetrahedronSpace, HexahedronSpace,
                   GimpSpace<3>, BSplineSpace<3>, BSplineGimpSpace<2>, BSplineGimpSpace<3>>;

/// The name of a space in the name of a typed test.
struct SpaceName {
  template <class Space>
  static std::string GetName(int) {
    constexpr int dim = Space::dim;
    if (std::is_same_v<Space, TriangleSpace>) return "Triangle";
    if (std::is_same_v<Space, TetrahedronSpace>) return "Tetrahedron";
    if (std::is_same_v<Space, BoxSpace<dim>>) return dim == 2 ? "Quadrilateral" : "Hexahedron";
    const std::string in_dimensions = std::to_string(dim) + "d";
    if (std::is_same_v<Space, BSplineSpace<dim>>) return "BSpline" + in_dimensions;
    return (std::is_same_v<Space, GimpSpace<dim>> ? "Gimp" : "BSplineGimp") + in_dimensions;
  }
};

/// E = 400 kPa, nu = 0.25; points at rest and stress-free, sorted: the Gauss points of simplices, two along each side
/// of squares and cubes.
template <class Space = TriangleSpace>
Body<Space> block(const Block& data = {});

/// Moves every point at random by up to `share` of a square, without leaving the grid or the filled height, and sorts.
template <class Space>
void scatter_positions(Body<Space>& body, std::mt19937& random, double share);

/// Gives every point a random velocity, each component in [-1, 1] m/s.
template <class Space>
void randomize_velocities(Body<Space>& body, std::mt19937& random);

/// Gives every point random stresses, each component in [-1, 1] kPa.
template <class Space>
void randomize_stresses(Body<Space>& body, std::mt19937& random);

/// Momentum of all points [kg m/s, in 2-D per m].
template <int dim>
Vector<dim> total_momentum(const Points<dim>& points);

} // namespace settle::mpm::test
