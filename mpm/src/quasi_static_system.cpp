#include "quasi_static_system.hpp"

#include <algorithm>
#include <atomic>

#include "point_motion.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

/// So many that one who has finished finds something left; in space more cells lie between two blocks, and are kept.
template <int dim>
constexpr int blocks_per_thread = dim == 2 ? 4 : 2;

std::size_t size_of(int i) {
  return static_cast<std::size_t>(i);
}

template <class Space>
CellNodes nodes_of_cells(const Body<Space>& body) {
  CellNodes cells;
  for (const int cell : body.cells.occupied) {
    const CellGradients<Space> cell_gradients(body, cell);
    for (int i = 0; i < cell_gradients.n_nodes(); ++i)
      cells.nodes.push_back(cell_gradients.node(i));
    cells.begin.push_back(cells.nodes.size());
  }
  return cells;
}

} // namespace

template <class Space>
void QuasiStaticSystem<Space>::renumber(const Body<Space>& body) {
  cells_ = nodes_of_cells(body);
  if (tangent_.set_pattern(number_unknowns(body))) solver_.forget();
  divide(body);
}

template <class Space>
CellEquations QuasiStaticSystem<Space>::number_unknowns(const Body<Space>& body) {
  CellEquations equations;
  equation_.assign(size_of(dim * body.space.n_nodes()), -1);
  for (const int node : cells_.nodes)
    for (int c = 0; c < dim; ++c)
      if (!body.fixed[size_of(node)][size_of(c)]) equation_[size_of(dim * node + c)] = 0;
  for (int& equation : equation_)
    if (equation == 0) equation = equations.size++;
  for (const int node : cells_.nodes)
    for (int c = 0; c < dim; ++c)
      equations.rows.push_back(equation_[size_of(dim * node + c)]);
  for (const std::size_t begin : cells_.begin)
    equations.begin.push_back(dim * begin);
  return equations;
}

/// Into blocks with about as many points each: one where a second thread would cost more than it brings.
template <class Space>
void QuasiStaticSystem<Space>::divide(const Body<Space>& body) {
  const auto useful = static_cast<int>(std::max<std::size_t>(1, body.points.size() / threads_.least_points));
  const int threads = std::min(threads_.most, useful), count = threads > 1 ? blocks_per_thread<dim> * threads : 1;
  std::vector<std::size_t> weights;
  for (const int cell : body.cells.occupied) {
    const PointRange range = points_in(body, cell);
    weights.push_back(range.last - range.first);
  }
  shares_ = equal_shares(count, threads);
  blocks_.emplace(shares_by_weight(weights, count).first, cells_, body.space.n_nodes());
  scratch_.resize(size_of(threads));
  kept_.resize(size_of(blocks_->n_kept()));
}

template <class Space>
bool QuasiStaticSystem<Space>::assemble(const Body<Space>& body, const Eigen::VectorXd& displacement,
                                        Eigen::VectorXd& internal) {
  internal.setZero();
  tangent_.set_zero();
  std::atomic<bool> sound = true;
  crew_.run(shares_, [&](int block, int thread) {
    if (sound && !add_own_cells(body, displacement, block, scratch_[size_of(thread)], internal)) sound = false;
  });
  if (!sound) return false;
  if (blocks_->n_kept() == 0) return true;
  crew_.run(shares_, [&](int block, int) {
    for (const int cell : blocks_->reaching(block))
      add(block, cell, kept_[size_of(blocks_->kept(cell))], internal);
  });
  return true;
}

template <class Space>
bool QuasiStaticSystem<Space>::add_own_cells(const Body<Space>& body, const Eigen::VectorXd& displacement, int block,
                                             Contribution& scratch, Eigen::VectorXd& internal) {
  for (int cell = blocks_->first_cell(block); cell < blocks_->first_cell(block + 1); ++cell) {
    const int kept = blocks_->kept(cell);
    Contribution& sum = kept < 0 ? scratch : kept_[size_of(kept)];
    if (!contribute(body, CellGradients<Space>(body, body.cells.occupied[size_of(cell)]), displacement, sum))
      return false;
    add(block, cell, sum, internal);
  }
  return true;
}

/// To what the block owns.
template <class Space>
void QuasiStaticSystem<Space>::add(int block, int cell, const Contribution& sum, Eigen::VectorXd& internal) {
  const std::size_t begin = cells_.begin[size_of(cell)];
  const auto n_nodes = static_cast<int>(cells_.begin[size_of(cell) + 1] - begin);
  for (int i = 0; i < n_nodes; ++i) {
    const int node = cells_.nodes[begin + size_of(i)];
    if (!blocks_->owns(block, node)) continue;
    internal.template segment<dim>(dim * node) += sum.force.template segment<dim>(dim * i);
    tangent_.add(size_of(cell), sum.tangent, dim * i, dim * (i + 1));
  }
}

template <class Space>
void QuasiStaticSystem<Space>::move_points(Body<Space>& body, const Eigen::VectorXd& displacement) {
  crew_.run(shares_, [&](int block, int) {
    for (int cell = blocks_->first_cell(block); cell < blocks_->first_cell(block + 1); ++cell)
      mpm::move_points(body, body.cells.occupied[size_of(cell)], displacement);
  });
}

template <class Space>
Eigen::VectorXd QuasiStaticSystem<Space>::free_part(const Eigen::VectorXd& full) const {
  Eigen::VectorXd part(tangent_.size());
  for (std::size_t dof = 0; dof < equation_.size(); ++dof)
    if (const int row = equation_[dof]; row >= 0) part[row] = full[static_cast<Eigen::Index>(dof)];
  return part;
}

template <class Space>
void QuasiStaticSystem<Space>::add_to_free(const Eigen::VectorXd& step, Eigen::VectorXd& full) const {
  for (std::size_t dof = 0; dof < equation_.size(); ++dof)
    if (const int row = equation_[dof]; row >= 0) full[static_cast<Eigen::Index>(dof)] += step[row];
}

#define SETTLE_INSTANTIATE(Space) template class QuasiStaticSystem<Space>;
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
