/// \file
/// The material points at which every solver samples its solution.
#pragma once

#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// One probe point in the design geometry.
struct ProbePoint {
  int layer = 1;              ///< 1 ... N
  double relative_height = 0; ///< xi in [0, 1] within its layer as placed; of a column only
  double x = 0, y = 0;        ///< horizontal position [m]; y only in 3-D
  double design_height = 0;   ///< z_{k-1} + xi t; across polygons: its height [m]
};

/// The points of one line, layer by layer; in a column from below, both ends of each layer included; across polygons
/// from one end of the line to the other, in every layer that holds the point. A body in space is probed in the middle
/// of its depth, in a valley wherever the line runs.
std::vector<ProbePoint> probe_points(const Case& study, const Probes& line);

/// From one end of a line across polygons to the other [m].
double length_of(const Probes& line);

/// From the start of a line across polygons to a point; y counts in a valley only [m].
double distance_from_start(const Probes& line, const ProbePoint& point);

} // namespace settle::exchange
