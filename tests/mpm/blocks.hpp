/// \file
/// Small bodies for tests of single phases.
#pragma once

#include <random>

#include "settle/mpm/body.hpp"
#include "settle/mpm/placement.hpp"

namespace settle::mpm::test {

/// A body of squares of 0.5 m, filled from below.
struct Block {
  int columns = 3;
  int rows = 4;
  int filled_rows = 3;
  double size = 0.5;     ///< [m]
  bool supported = true; ///< rollers on both sides and the base; otherwise free
};

inline constexpr double block_density = 1800.0; ///< [kg/m3]

/// E = 400 kPa, nu = 0.25; points at rest and stress-free, sorted.
Body<TriangleGrid> block(const Block& data = {});

/// Moves every point at random by up to `share` of a square, without leaving the grid or the filled height, and sorts.
void scatter_positions(Body<TriangleGrid>& body, std::mt19937& random, double share);

/// Gives every point a random velocity, each component in [-1, 1] m/s.
void randomize_velocities(Body<TriangleGrid>& body, std::mt19937& random);

/// Gives every point random stresses, each component in [-1, 1] kPa.
void randomize_stresses(Body<TriangleGrid>& body, std::mt19937& random);

/// Momentum of all points [kg m/s per m].
Vector<2> total_momentum(const Points<2>& points);

} // namespace settle::mpm::test
