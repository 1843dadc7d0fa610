#include "settle/fem/requirements.hpp"

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "settle/exchange/fitting_size.hpp"

namespace settle::fem {
namespace {

void require_small_strain(const exchange::Case& study) {
  if (study.fem.kinematics == exchange::Kinematics::small) return;
  throw exchange::InputError(exchange::Complaint{
      .where = study.where("fem.kinematics"),
      .what = "the finite element solver of this version is small strain only",
      .given = fmt::format("fem.kinematics = \"{}\"", exchange::name_of(study.fem.kinematics)),
      .allowed = fmt::format("\"{}\"", exchange::name_of(exchange::Kinematics::small)),
      .remedy = "use fem.kinematics = \"small\" (comparisons then use the exact small-strain solution), or solve the "
                "case at finite strain with settle-mpm"});
}

} // namespace

std::array<unsigned, 3> cells_along_axes(const exchange::Case& study) {
  const exchange::ElementCounts counts = exchange::count_elements(study, "fem.element_size", study.fem.element_size);
  const auto across = static_cast<unsigned>(counts.across);
  const auto deep = static_cast<unsigned>(counts.deep);
  const auto vertical = static_cast<unsigned>(counts.per_layer * study.construction.layers);
  if (study.geometry.dimension == 3) return {across, deep, vertical};
  return {across, vertical, 1};
}

void require_solvable(const exchange::Case& study) {
  require_small_strain(study);
  static_cast<void>(cells_along_axes(study));
}

} // namespace settle::fem
