/// \file
/// What meshes in space have to fulfil to be built up at finite strain.
#pragma once

#include "settle/exchange/case.hpp"

namespace settle::fem {

/// A layer moves with what is below each of its points: with nothing of it, or with all. Throws InputError where a
/// layer of a mesh of hexahedra leans on what was placed before, or lies on it in part only.
void require_layers_above(const exchange::Case& study);

} // namespace settle::fem
