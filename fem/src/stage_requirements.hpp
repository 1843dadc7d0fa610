/// \file
/// What stages ask for that the mesh of a drawn body has to be able to give.
#pragma once

#include "polygon_mesh.hpp"
#include "settle/exchange/case.hpp"

namespace settle::fem {

/// Throws InputError where ground has a k0 and its law, at finite strain, keeps no stress.
void require_laws_of_ground(const exchange::Case& study);

/// Throws InputError where ground with a k0 is not level, where a load does not lie on the surface as a whole, and
/// where at finite strain a layer lies on others in part only or beside them.
void require_stages(const exchange::Case& study, const PlaneMesh& mesh);

} // namespace settle::fem
