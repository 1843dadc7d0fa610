#include "point_motion.hpp"

#include "cell_contribution.hpp"
#include "constitutive_update.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

template <class Space>
void move_points(Body<Space>& body, int cell, const Eigen::VectorXd& displacement) {
  constexpr int dim = Space::dim;
  auto& points = body.points;
  const CellGradients<Space> cell_gradients(body, cell);
  cell_gradients.for_each_patch([&](const Patch<Space>& patch) {
    const auto kinematics = kinematics_of(body, cell_gradients, patch, displacement);
    for (std::size_t p = patch.points.first; p < patch.points.last; ++p) {
      const auto stencil = body.space.stencil(cell, points, p);
      Vector<dim> move = Vector<dim>::Zero();
      for (int i = 0; i < stencil.size(); ++i)
        move += stencil.value(i) * displacement.template segment<dim>(dim * stencil.node(i));
      for (int d = 0; d < dim; ++d)
        points.position[static_cast<std::size_t>(d)][p] += move[d];
    }
    deform_points(body, patch.points, kinematics, StrainMeasure::logarithmic);
  });
}

#define SETTLE_INSTANTIATE(Space) template void move_points(Body<Space>&, int, const Eigen::VectorXd&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
