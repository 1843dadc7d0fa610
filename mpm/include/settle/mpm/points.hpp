/// \file
/// Material points as a structure of arrays, kept sorted by cell.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace settle::mpm {

template <int dim>
using Vector = Eigen::Matrix<double, dim, 1>;
template <int dim>
using Tensor = Eigen::Matrix<double, dim, dim>;

/// One entry for each axis.
template <class T, int dim>
using PerAxis = std::array<T, static_cast<std::size_t>(dim)>;

/// Stored components of the Cauchy stress: xx yy zz xy in plane strain, xx yy zz xy yz xz in 3-D.
template <int dim>
inline constexpr std::size_t stress_size = dim == 2 ? 4 : 6;

/// What a new point is made of. Stress and velocity of a new point are zero.
template <int dim>
struct NewPoint {
  int layer = 1;
  bool refilled = false;
  Vector<dim> position = Vector<dim>::Zero(); ///< where it is placed [m]
  double volume = 0;                          ///< [m3/m] in 2-D
  double density = 0;                         ///< [kg/m3]
  double preconsolidation_pressure = 0;       ///< [Pa]; only kept where points harden
  /// Of the rectangle or cuboid it fills [m]; zero: a square, a cube. Only kept where points carry their domains.
  Vector<dim> half_lengths = Vector<dim>::Zero();
};

/// n material points. Every array has n entries; the points of a cell are contiguous after `sort_by_cell`.
template <int dim>
struct Points {
  std::vector<std::uint64_t> id;  ///< stays with the point; numbered in order of placement from 1
  std::vector<std::int32_t> cell; ///< of the grid, as of the last sort; -1 for a point not sorted in yet
  std::vector<std::int32_t> layer;
  std::vector<std::uint8_t> refilled;
  std::vector<double> mass;   ///< [kg/m] in 2-D
  std::vector<double> volume; ///< current [m3/m] in 2-D
  PerAxis<std::vector<double>, dim> position;
  PerAxis<std::vector<double>, dim> placed; ///< position at placement [m]
  PerAxis<std::vector<double>, dim> velocity;
  std::array<std::vector<double>, stress_size<dim>> stress; ///< Cauchy, tension positive [Pa]
  /// Deformation gradient since placement, row by row; empty unless `tracks_deformation`.
  std::array<std::vector<double>, static_cast<std::size_t>(dim* dim)> deformation;
  bool tracks_deformation = false; ///< set before the first point is added; for laws that need it
  /// Half the sides of the rectangle or cuboid along the axes that a point fills [m]; empty unless `has_domains`.
  PerAxis<std::vector<double>, dim> half_length;
  bool has_domains = false;                      ///< set before the first point is added; for spaces that need it
  std::vector<double> plastic_strain;            ///< accumulated, equivalent, deviatoric [-]; empty unless `yields`
  std::vector<double> preconsolidation_pressure; ///< [Pa]; empty unless `hardens`
  bool yields = false, hardens = false;          ///< set before the first point is added; for laws of soils
  std::uint64_t next_id = 1;

  [[nodiscard]] std::size_t size() const { return id.size(); }
  [[nodiscard]] double density(std::size_t p) const { return mass[p] / volume[p]; }
  [[nodiscard]] Vector<dim> position_of(std::size_t p) const {
    Vector<dim> x;
    for (int c = 0; c < dim; ++c)
      x[c] = position[static_cast<std::size_t>(c)][p];
    return x;
  }

  [[nodiscard]] Tensor<dim> deformation_of(std::size_t p) const {
    Tensor<dim> gradient;
    for (int i = 0; i < dim * dim; ++i)
      gradient(i / dim, i % dim) = deformation[static_cast<std::size_t>(i)][p];
    return gradient;
  }
  void set_deformation(std::size_t p, const Tensor<dim>& gradient) {
    for (int i = 0; i < dim * dim; ++i)
      deformation[static_cast<std::size_t>(i)][p] = gradient(i / dim, i % dim);
  }

  [[nodiscard]] Vector<dim> half_lengths_of(std::size_t p) const {
    Vector<dim> lengths;
    for (int c = 0; c < dim; ++c)
      lengths[c] = half_length[static_cast<std::size_t>(c)][p];
    return lengths;
  }

  /// Appends a stress-free point at rest.
  void add(const NewPoint<dim>& point);
  /// Brings the points into the order given: new point i is old point order[i]. Points that are not in it are gone.
  void permute(const std::vector<std::uint32_t>& order) {
    for (int array = 0; array < n_arrays; ++array)
      permute_array(array, order);
  }
  /// The same for one of the arrays, 0 ... n_arrays - 1.
  void permute_array(int array, const std::vector<std::uint32_t>& order);
  static constexpr int n_arrays = 8 + 4 * dim + static_cast<int>(stress_size<dim>) + dim * dim;
};

extern template struct Points<2>;
extern template struct Points<3>;

} // namespace settle::mpm
