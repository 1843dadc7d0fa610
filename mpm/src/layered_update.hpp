/// \file
/// Response and update of points whose layers are of different materials, or are soils: each by its own law and from
/// its own stress and state, whatever it shares the deformation with.
#pragma once

#include "constitutive_update.hpp"

namespace settle::mpm {

/// As `respond`: the volume average over the points.
template <class Space>
Response<Space::dim> layered_response(const Body<Space>& body, PointRange range, double points_volume,
                                      const IncrementalKinematics<Space::dim>& kinematics);

/// Stress, state and, where tracked, deformation of the points at the end of the increment.
template <class Space>
void deform_layered_points(Body<Space>& body, PointRange range, const IncrementalKinematics<Space::dim>& kinematics,
                           StrainMeasure measure);

} // namespace settle::mpm
