#include "settle/mpm/nodal_forces.hpp"

#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

template <class Space>
Eigen::VectorXd external_forces(const Body<Space>& body, const Gravity& gravity) {
  constexpr int dim = Space::dim;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(dim * body.space.n_nodes());
  for (const int cell : body.cells.occupied) {
    const auto [first, last] = points_in(body, cell);
    for (std::size_t p = first; p < last; ++p) {
      const auto stencil = body.space.stencil(cell, body.points, p);
      const Vector<dim> weight = body.points.mass[p] * gravity.pull(body.points, p);
      for (int i = 0; i < stencil.size(); ++i)
        forces.template segment<dim>(dim * stencil.node(i)) += stencil.value(i) * weight;
    }
  }
  return forces;
}

#define SETTLE_INSTANTIATE(Space) template Eigen::VectorXd external_forces(const Body<Space>&, const Gravity&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
