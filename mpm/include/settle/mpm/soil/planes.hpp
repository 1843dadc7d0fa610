/// \file
/// Yield surfaces made of planes in principal stresses: their faces, edges and corners.
#pragma once

#include <span>

#include "settle/mpm/soil/principal.hpp"

namespace settle::mpm::soil {

/// normal . stress <= limit; plastic strain flows along `flow`.
struct Plane {
  Values normal;
  Values flow;
  double limit = 0; ///< [Pa]
};

/// Where a trial stress returns to: stress = trial - D sum_k a_k flow_k with a_k >= 0 for the planes it ends on, and no
/// plane passed (Koiter 1953). The trial's values are in order, the largest first, and so are the end's. Faces, edges
/// and corners are tried in turn, each exact: the planes are linear (Clausen, Damkilde & Andersen 2007). std::nullopt
/// where no plane is passed.
///
/// `apex`: where the planes of a cone meet; plastic strain may flow anywhere there, and a trial stress beyond all faces
/// and edges returns to it (de Souza Neto, Peric & Owen 2008, section 8.2.3).
std::optional<Returned> return_to_planes(const Lame& lame, std::span<const Plane> planes,
                                         const std::optional<Values>& apex, const Values& trial);

} // namespace settle::mpm::soil
