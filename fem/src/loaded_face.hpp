/// \file
/// The part of a face that a load acts on.
#pragma once

#include <array>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature.h>

namespace settle::fem {

/// Gauss points over what lies between shares 0 and 1 of a line, the shares of a face's vertices given: between them
/// the share is (bi)linear in unit coordinates. `n` along each axis, and six more along the ends of the line where
/// these cut the face: they are hyperbolas there, unless it is a parallelogram. Weights add up to that part of the unit
/// face.
template <int dim>
dealii::Quadrature<dim - 1>
quadrature_between(const std::array<double, dealii::GeometryInfo<dim>::vertices_per_face>& shares, unsigned n);

} // namespace settle::fem
