/// \file
/// From the body to the result file's stage.
#pragma once

#include <vector>

#include "design.hpp"
#include "settle/exchange/result.hpp"
#include "settle/mpm/loading.hpp"
#include "settle/mpm/placement.hpp"

namespace settle::mpm {

/// Components of a stress in the result file: xx yy zz xy yz xz.
inline constexpr std::size_t recorded_stress_size = 6;

/// All material points, in the result file's layout.
template <int dim>
exchange::SamplePoints sample_points(const Points<dim>& points);

/// The case's probes at this stage: linear in placed height between the rows of the layer's own, not refilled points
/// (all points of a layer at one placed height make a row), continued linearly to the layer's two ends. `placements`
/// holds the layers placed so far.
template <int dim>
std::map<std::string, exchange::ProbeSamples> sample_probes(const exchange::Case& study, const Points<dim>& points,
                                                            const std::vector<LayerPlacement>& placements);

/// The case's probes across polygons of the layers that are present: linear functions through the nearest points of the
/// layer, by their places in the section: in space the mean of rows along y; in a valley by their places in the body.
template <int dim>
std::map<std::string, exchange::ProbeSamples> sample_drawn_probes(const exchange::Case& study,
                                                                  const Points<dim>& points, const Design& design,
                                                                  const std::vector<int>& present);

/// Of what is drawn: the highest point plus half the side of its square, of a refilled one half the height of its row.
/// `row`: what a point fills along y, 1 in 2-D [m]; `spacing`: of points [m].
template <int dim>
double highest_surface(const Points<dim>& points, double row, double spacing);

/// Height of a column's surface [m]: points' volume over the width, in 3-D over the plan's area; for `drop`, where
/// there may be gaps, the highest point plus half the height of its row.
template <class Space>
double surface_height(const Body<Space>& body, exchange::Convention convention);

} // namespace settle::mpm
