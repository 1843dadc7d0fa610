#include "settle/mpm/quasi_static_step.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/SparseLU>

#include "constitutive_update.hpp"
#include "settle/mpm/nodal_forces.hpp"

namespace settle::mpm {

namespace {

constexpr int max_iterations = 25;

/// Equation numbers of the free degrees of freedom of nodes that touch an occupied cell; -1 elsewhere.
struct Numbering {
  std::vector<std::int32_t> cells; ///< the occupied ones: with the equations, they make the matrix's pattern
  std::vector<int> equation;       ///< dim * node + direction -> row
  int size = 0;

  bool operator==(const Numbering&) const = default;
};

template <class Grid>
Numbering number_unknowns(const Body<Grid>& body) {
  constexpr int dim = Grid::dim;
  Numbering numbering{.cells = body.cells.occupied, .equation = {}, .size = 0};
  numbering.equation.assign(static_cast<std::size_t>(dim * body.grid.n_nodes()), -1);
  for (const int cell : body.cells.occupied)
    for (const int node : body.grid.nodes(cell))
      for (int c = 0; c < dim; ++c)
        if (!body.fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(c)])
          numbering.equation[static_cast<std::size_t>(dim * node + c)] = 0;
  for (int& equation : numbering.equation)
    if (equation == 0) equation = numbering.size++;
  return numbering;
}

/// Gradient of a nodal displacement field in a cell.
template <class Grid>
Tensor<Grid::dim> gradient_in(const Grid& grid, int cell, const Eigen::VectorXd& displacement) {
  constexpr int dim = Grid::dim;
  Tensor<dim> gradient = Tensor<dim>::Zero();
  const auto nodes = grid.nodes(cell);
  for (int i = 0; i < Grid::nodes_per_cell; ++i)
    gradient += displacement.template segment<dim>(dim * nodes[static_cast<std::size_t>(i)]) *
                grid.gradients(cell).col(i).transpose();
  return gradient;
}

/// Internal forces of one cell at the end of the increment and their derivative.
template <class Grid>
struct CellContribution {
  static constexpr int dofs = Grid::dim * Grid::nodes_per_cell;
  Eigen::Matrix<double, dofs, 1> force;
  Eigen::Matrix<double, dofs, dofs> tangent;
};

template <class Grid>
CellContribution<Grid> contribution_of(const Body<Grid>& body, int cell, const CellStress<Grid::dim>& start,
                                       const IncrementalKinematics<Grid::dim>& kinematics) {
  constexpr int dim = Grid::dim;
  const typename Grid::Gradients g = kinematics.inverse.transpose() * body.grid.gradients(cell);
  const CellResponse<Grid> response = respond(body, cell, start, kinematics);
  const Tensor<dim>& sigma = response.stress;
  const double volume = integration_volume(body, start.points_volume) * kinematics.volume_ratio;
  CellContribution<Grid> result;
  for (int i = 0; i < Grid::nodes_per_cell; ++i)
    result.force.template segment<dim>(dim * i) = volume * sigma * g.col(i);
  for (int j = 0; j < Grid::nodes_per_cell; ++j)
    for (int b = 0; b < dim; ++b) {
      const Tensor<dim>& d_sigma = response.variations[static_cast<std::size_t>(dim * j + b)];
      for (int i = 0; i < Grid::nodes_per_cell; ++i)
        result.tangent.template block<dim, 1>(dim * i, dim * j + b) =
            volume * (d_sigma * g.col(i) + g(b, j) * (sigma * g.col(i)) - g(b, i) * (sigma * g.col(j)));
    }
  return result;
}

/// Moves the points with the nodes and deforms them with their cell.
template <class Grid>
void move_points(Body<Grid>& body, const Eigen::VectorXd& displacement) {
  constexpr int dim = Grid::dim;
  auto& points = body.points;
  for (const int cell : body.cells.occupied) {
    const auto nodes = body.grid.nodes(cell);
    const IncrementalKinematics<dim> kinematics(gradient_in(body.grid, cell, displacement));
    const auto c = static_cast<std::size_t>(cell);
    for (std::size_t p = body.cells.begin[c]; p < body.cells.begin[c + 1]; ++p) {
      const auto values = body.grid.values(cell, points.position_of(p));
      Vector<dim> move = Vector<dim>::Zero();
      for (std::size_t i = 0; i < nodes.size(); ++i)
        move += values[i] * displacement.template segment<dim>(dim * nodes[i]);
      for (int d = 0; d < dim; ++d)
        points.position[static_cast<std::size_t>(d)][p] += move[d];
    }
    deform_points(body, cell, kinematics, StrainMeasure::logarithmic);
  }
}

} // namespace

/// The linear system, kept between increments for its symbolic analysis.
template <class Grid>
struct QuasiStaticStep<Grid>::System {
  static constexpr int dim = Grid::dim;

  Numbering numbering;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver;
  std::vector<Eigen::Triplet<double>> triplets;

  void renumber(const Body<Grid>& body) {
    Numbering fresh = number_unknowns(body);
    analysed_ = analysed_ && fresh == numbering;
    numbering = std::move(fresh);
  }

  /// Internal forces at `displacement`, and the tangent's entries; false if a cell turns inside out.
  bool assemble(const Body<Grid>& body, const std::vector<CellStress<dim>>& start, const Eigen::VectorXd& displacement,
                Eigen::VectorXd& internal) {
    internal.setZero();
    triplets.clear();
    for (std::size_t k = 0; k < body.cells.occupied.size(); ++k) {
      const int cell = body.cells.occupied[k];
      const IncrementalKinematics<dim> kinematics(gradient_in(body.grid, cell, displacement));
      if (!(kinematics.volume_ratio > 0.0)) return false;
      scatter(body.grid.nodes(cell), contribution_of(body, cell, start[k], kinematics), internal);
    }
    return true;
  }

  /// Solves tangent * step = residual; false if the matrix is singular.
  bool solve(const Eigen::VectorXd& residual, Eigen::VectorXd& step) {
    Eigen::SparseMatrix<double> matrix(numbering.size, numbering.size);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    if (!analysed_) solver.analyzePattern(matrix);
    analysed_ = true;
    solver.factorize(matrix);
    if (solver.info() != Eigen::Success) return false;
    step = solver.solve(residual);
    return step.allFinite();
  }

  /// The entries of a full nodal vector at the free degrees of freedom.
  [[nodiscard]] Eigen::VectorXd free_part(const Eigen::VectorXd& full) const {
    Eigen::VectorXd part(numbering.size);
    for (std::size_t dof = 0; dof < numbering.equation.size(); ++dof)
      if (const int row = numbering.equation[dof]; row >= 0) part[row] = full[static_cast<Eigen::Index>(dof)];
    return part;
  }

  void add_to_free(const Eigen::VectorXd& step, Eigen::VectorXd& full) const {
    for (std::size_t dof = 0; dof < numbering.equation.size(); ++dof)
      if (const int row = numbering.equation[dof]; row >= 0) full[static_cast<Eigen::Index>(dof)] += step[row];
  }

private:
  bool analysed_ = false;

  void scatter(const typename Grid::Nodes& nodes, const CellContribution<Grid>& cell, Eigen::VectorXd& internal) {
    for (int i = 0; i < CellContribution<Grid>::dofs; ++i) {
      const int dof_i = dim * nodes[static_cast<std::size_t>(i / dim)] + i % dim;
      internal[dof_i] += cell.force[i];
      const int row = numbering.equation[static_cast<std::size_t>(dof_i)];
      if (row < 0) continue;
      for (int j = 0; j < CellContribution<Grid>::dofs; ++j) {
        const int dof_j = dim * nodes[static_cast<std::size_t>(j / dim)] + j % dim;
        const int column = numbering.equation[static_cast<std::size_t>(dof_j)];
        if (column >= 0) triplets.emplace_back(row, column, cell.tangent(i, j));
      }
    }
  }
};

template <class Grid>
QuasiStaticStep<Grid>::QuasiStaticStep(double tolerance) : system_(std::make_unique<System>()), tolerance_(tolerance) {}
template <class Grid>
QuasiStaticStep<Grid>::QuasiStaticStep(QuasiStaticStep&&) noexcept = default;
template <class Grid>
QuasiStaticStep<Grid>::~QuasiStaticStep() = default;

template <class Grid>
IncrementReport QuasiStaticStep<Grid>::advance(Body<Grid>& body, const Gravity& gravity, double fraction) {
  System& system = *system_;
  system.renumber(body);
  std::vector<CellStress<Grid::dim>> start;
  for (const int cell : body.cells.occupied)
    start.push_back(average_stress_of(body, cell));
  const Eigen::VectorXd external = external_forces(body, gravity);
  const double scale = external.norm();
  Eigen::VectorXd internal(external.size()), displacement = Eigen::VectorXd::Zero(external.size()), target, step;

  IncrementReport report;
  for (int iteration = 0; iteration <= max_iterations; ++iteration) {
    if (!system.assemble(body, start, displacement, internal)) return report;
    if (iteration == 0) target = internal + fraction * (external - internal);
    const Eigen::VectorXd residual = system.free_part(target - internal);
    report.residuals.push_back(residual.norm() / scale);
    report.out_of_balance = report.residuals.back();
    report.converged = report.out_of_balance <= tolerance_;
    if (report.converged || iteration == max_iterations || !std::isfinite(report.out_of_balance)) break;
    ++report.linear_solves;
    if (!system.solve(residual, step)) return report;
    system.add_to_free(step, displacement);
  }
  if (!report.converged) return report;
  report.base_reaction = base_reaction(body, internal, external);
  report.largest_displacement = displacement.template lpNorm<Eigen::Infinity>();
  move_points(body, displacement);
  body.sort();
  if (body.average_stress) replace_stress_by_cell_average(body);
  return report;
}

template class QuasiStaticStep<TriangleGrid>;

} // namespace settle::mpm
