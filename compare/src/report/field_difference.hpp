/// \file
/// MPM - FEM at the material points of MPM.
#pragma once

#include "field_picture.hpp"

namespace settle::compare::report {

/// A field of one component at a sample point [SI unit]; NaN for any other quantity.
double value_at(const exchange::SamplePoints& points, std::size_t dim, std::size_t i, exchange::Quantity quantity);

/// MPM - FEM at every material point that was not refilled, at its place in the design geometry, where FEM is what its
/// element says between its quadrature points. Nothing where one of the two has no result or FEM does not come in
/// elements of the plane; `missing` says how many points lie in no element.
std::optional<FieldLeg> field_difference(const RunOutcome& run, exchange::Quantity quantity,
                                         std::vector<std::string>& missing);

} // namespace settle::compare::report
