/// \file
/// From the body to the result file's stage.
#pragma once

#include <vector>

#include "settle/exchange/result.hpp"
#include "settle/mpm/loading.hpp"
#include "settle/mpm/placement.hpp"

namespace settle::mpm {

/// All material points, in the result file's layout.
exchange::SamplePoints sample_points(const Points<2>& points);

/// The case's probes at this stage: linear in placed height between the rows of the layer's own, not refilled points
/// (all points of a layer at one placed height make a row), continued linearly to the layer's two ends. `placements`
/// holds the layers placed so far. Across polygons: scattered_sampling.hpp.
std::map<std::string, exchange::ProbeSamples> sample_probes(const exchange::Case& study, const Points<2>& points,
                                                            const std::vector<LayerPlacement>& placements);

/// Height of the surface [m]: points' volume over the width; for `drop`, where there may be gaps, the highest point
/// plus half the height of its row.
template <class Space>
double surface_height(const Body<Space>& body, exchange::Convention convention);

} // namespace settle::mpm
