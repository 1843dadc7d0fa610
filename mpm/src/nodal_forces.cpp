#include "settle/mpm/nodal_forces.hpp"

namespace settle::mpm {

template <class Grid>
Eigen::VectorXd external_forces(const Body<Grid>& body, const Gravity& gravity) {
  constexpr int dim = Grid::dim;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(dim * body.grid.n_nodes());
  for (const int cell : body.cells.occupied) {
    const auto nodes = body.grid.nodes(cell);
    const auto c = static_cast<std::size_t>(cell);
    for (std::size_t p = body.cells.begin[c]; p < body.cells.begin[c + 1]; ++p) {
      const auto values = body.grid.values(cell, body.points.position_of(p));
      const double weight = body.points.mass[p] * gravity.on(body.points.layer[p]);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        forces[dim * nodes[i] + dim - 1] -= values[i] * weight;
    }
  }
  return forces;
}

template Eigen::VectorXd external_forces(const Body<TriangleGrid>&, const Gravity&);

} // namespace settle::mpm
