#include "settle/fem/requirements.hpp"

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "settle/exchange/fitting_size.hpp"

namespace settle::fem {
namespace {

/// At finite strain a layer lies on what has settled below it.
void require_placement(const exchange::Case& study) {
  using exchange::Convention;
  if (study.fem.kinematics == exchange::Kinematics::small) return;
  const Convention convention = study.construction.convention;
  const auto refuse = [&](const std::string& why) {
    throw exchange::InputError(exchange::Complaint{
        .where = study.where("construction.convention"),
        .what = fmt::format("finite elements at finite strain cannot build by \"{}\": {}",
                            exchange::name_of(convention), why),
        .given = fmt::format("construction.convention = \"{}\" with fem.kinematics = \"finite\"",
                             exchange::name_of(convention)),
        .allowed = fmt::format("\"{}\" or \"{}\"", exchange::name_of(Convention::floating),
                               exchange::name_of(Convention::level_up)),
        .remedy = "use \"level-up\", which tends to \"refill\" with the number of layers, or fem.kinematics = "
                  "\"small\", for which all conventions are the same column, or solve the case with settle-mpm alone"});
  };
  if (convention == Convention::refill) refuse("a mesh takes no material during a stage");
  if (convention == Convention::drop && study.construction.layers > 1)
    refuse("a mesh cannot close the gap to the settled surface");
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
  require_placement(study);
  static_cast<void>(cells_along_axes(study));
}

} // namespace settle::fem
