/// \file
/// How an embankment is divided before it is meshed.
#pragma once

#include "settle/exchange/case.hpp"

namespace settle::fem {

/// The case with the same body drawn by other polygons, as many as its mesh needs to have right angles but at slopes:
/// vertical lines through both ends of every layer's top leave rectangles and, at the slopes, triangles. Its
/// `fem.element_size` is that of the longest edge; cells are of the size given on average, as the root of their area,
/// and nowhere higher than it.
exchange::Case divided_embankment(const exchange::Case& study);

} // namespace settle::fem
