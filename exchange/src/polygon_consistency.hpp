/// \file
/// Does a case say everything its shape needs, and nothing that belongs to another shape?
#pragma once

#include "settle/exchange/case.hpp"
#include "settle/exchange/reading.hpp"

namespace settle::exchange {

/// Complains about an embankment without measures or without a layer of fill; to be called before it is drawn.
void check_embankment(const Case& study, Reading& reading);

/// Complains about a mesh that is not stated, and about what would be drawn beside it; to be called before it is read.
void check_mesh(const Case& study, Reading& reading);

/// Complains about lengths a column lacks, polygons that are none or overlap, layers without polygons; to be called
/// before the extent of polygons is taken.
void check_shape(const Case& study, Reading& reading);

/// Complains about probes, supports and conventions that do not go with polygons.
void check_polygons(const Case& study, Reading& reading);

} // namespace settle::exchange
