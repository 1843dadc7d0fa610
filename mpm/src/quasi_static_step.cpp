#include "settle/mpm/quasi_static_step.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "cell_gradients.hpp"
#include "constitutive_update.hpp"
#include "mean_volume.hpp"
#include "settle/mpm/nodal_forces.hpp"
#include "settle/mpm/spaces.hpp"
#include "tangent_matrix.hpp"
#include "tangent_solver.hpp"

namespace settle::mpm {

namespace {

constexpr int max_iterations = 25;

/// How exactly the next linear system is solved, relative to its right side: with a tenth of the residual, a share
/// of the load, Newton's iteration stays quadratic (Dembo, Eisenstat & Steihaug 1982).
double linear_tolerance(double residual) {
  return std::clamp(0.1 * residual, 1e-13, 0.01);
}

/// Equation numbers of the free degrees of freedom of nodes that points touch.
struct Numbering {
  std::vector<int> equation; ///< dim * node + direction -> row; -1 where nothing is free
  CellEquations cells;       ///< of the occupied cells, in their order
};

/// Nodes of the occupied cells, cell by cell; `begin` as in CellEquations, for degrees of freedom.
template <class Space>
std::vector<int> nodes_of_cells(const Body<Space>& body, std::vector<std::size_t>& begin) {
  std::vector<int> nodes;
  begin.assign(1, 0);
  for (const int cell : body.cells.occupied) {
    const CellGradients<Space> cell_gradients(body, cell);
    for (int i = 0; i < cell_gradients.n_nodes(); ++i)
      nodes.push_back(cell_gradients.node(i));
    begin.push_back(Space::dim * nodes.size());
  }
  return nodes;
}

template <class Space>
Numbering number_unknowns(const Body<Space>& body) {
  constexpr int dim = Space::dim;
  Numbering numbering;
  numbering.equation.assign(static_cast<std::size_t>(dim * body.space.n_nodes()), -1);
  const std::vector<int> nodes = nodes_of_cells(body, numbering.cells.begin);
  for (const int node : nodes)
    for (int c = 0; c < dim; ++c)
      if (!body.fixed[static_cast<std::size_t>(node)][static_cast<std::size_t>(c)])
        numbering.equation[static_cast<std::size_t>(dim * node + c)] = 0;
  for (int& equation : numbering.equation)
    if (equation == 0) equation = numbering.cells.size++;
  for (const int node : nodes)
    for (int c = 0; c < dim; ++c)
      numbering.cells.rows.push_back(numbering.equation[static_cast<std::size_t>(dim * node + c)]);
  return numbering;
}

/// Gradient of an increment of the nodes' displacement.
template <class Space>
Tensor<Space::dim> gradient_of(const CellGradients<Space>& cell, const typename Space::Stencil::Gradients& gradients,
                               const Eigen::VectorXd& displacement) {
  constexpr int dim = Space::dim;
  Tensor<dim> gradient = Tensor<dim>::Zero();
  for (int i = 0; i < cell.n_nodes(); ++i)
    gradient += displacement.template segment<dim>(dim * cell.node(i)) * gradients.col(i).transpose();
  return gradient;
}

/// Deformation of a patch that its points feel in an increment of the nodes' displacement.
template <class Space>
IncrementalKinematics<Space::dim> kinematics_of(const Body<Space>& body, const CellGradients<Space>& cell,
                                                const Patch<Space>& patch, const Eigen::VectorXd& displacement) {
  const Tensor<Space::dim> own = gradient_of(cell, patch.gradients, displacement);
  if (!body.mean_volume) return IncrementalKinematics<Space::dim>(own);
  return IncrementalKinematics<Space::dim>(
      with_volume_of<Space::dim>(own, gradient_of(cell, cell.mean_gradients(), displacement)));
}

/// A square matrix, on the stack where it is small enough.
template <int size>
using SquareMatrix = std::conditional_t<size * size * sizeof(double) <= EIGEN_STACK_ALLOCATION_LIMIT,
                                        Eigen::Matrix<double, size, size>, Eigen::MatrixXd>;

/// Internal forces of one cell at the end of the increment and their derivative; the first dim * n_nodes() entries.
template <class Space>
struct CellContribution {
  static constexpr int max_dofs = Space::dim * Space::max_nodes;
  Eigen::Matrix<double, max_dofs, 1> force = Eigen::Matrix<double, max_dofs, 1>::Zero();
  SquareMatrix<max_dofs> tangent = SquareMatrix<max_dofs>::Zero(max_dofs, max_dofs);
};

/// Adds the force f_i = v J sigma g_i of a patch with current gradients g = F^-T (gradients at the start), and its
/// derivative: d(v J) = v J div(du), d(g_i) = -(grad du)^T g_i.
template <class Space>
void add_patch(const Body<Space>& body, const CellGradients<Space>& cell, const Patch<Space>& patch,
               const IncrementalKinematics<Space::dim>& kinematics, CellContribution<Space>& sum) {
  constexpr int dim = Space::dim;
  const typename Space::Stencil::Gradients g = kinematics.inverse.transpose() * patch.gradients;
  const Response<dim> response = respond(body, patch.points, average_stress_of(body.points, patch.points), kinematics);
  const Tensor<dim>& sigma = response.stress;
  const double volume = patch.volume * kinematics.volume_ratio;
  const typename Space::Stencil::Gradients traction = volume * sigma * g;
  for (int j = 0; j < cell.n_nodes(); ++j) {
    sum.force.template segment<dim>(dim * j) += traction.col(j);
    for (int b = 0; b < dim; ++b) {
      Tensor<dim> d_sigma = g(b, j) * sigma;
      for (int a = 0; a < dim; ++a)
        d_sigma += g(a, j) * response.by_gradient[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)];
      const Tensor<dim> scaled = volume * d_sigma;
      for (int i = 0; i < cell.n_nodes(); ++i)
        sum.tangent.template block<dim, 1>(dim * i, dim * j + b) += scaled * g.col(i) - g(b, i) * traction.col(j);
    }
  }
}

/// The same for a body with `mean_volume`: a gradient h on top of the increment is felt as
/// h + (tr(h of the cell) - tr h) / dim I.
template <class Space>
void add_patch_of_mean_volume(const Body<Space>& body, const CellGradients<Space>& cell, const Patch<Space>& patch,
                              const Eigen::VectorXd& displacement, CellContribution<Space>& sum) {
  constexpr int dim = Space::dim;
  using Gradients = typename Space::Stencil::Gradients;
  const Tensor<dim> unit = Tensor<dim>::Identity();
  const auto current = [&](const Gradients& gradients) -> Gradients {
    return (unit + gradient_of(cell, gradients, displacement)).inverse().transpose() * gradients;
  };
  const Gradients g = current(patch.gradients), m = current(cell.mean_gradients());
  const auto kinematics = kinematics_of(body, cell, patch, displacement);
  const Response<dim> response = respond(body, patch.points, average_stress_of(body.points, patch.points), kinematics);
  const double volume = patch.volume * kinematics.volume_ratio, mean = response.stress.trace() / dim;
  const Tensor<dim> deviator = response.stress - mean * unit;
  const Gradients by_point = volume * deviator * g, by_cell = volume * mean * m;
  Tensor<dim> by_swelling = Tensor<dim>::Zero();
  for (std::size_t c = 0; c < dim; ++c)
    by_swelling += response.by_gradient[c][c];
  for (int j = 0; j < cell.n_nodes(); ++j) {
    sum.force.template segment<dim>(dim * j) += by_point.col(j) + by_cell.col(j);
    for (int b = 0; b < dim; ++b) {
      Tensor<dim> d_sigma = (m(b, j) - g(b, j)) / dim * by_swelling;
      for (int a = 0; a < dim; ++a)
        d_sigma += g(a, j) * response.by_gradient[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)];
      const Gradients d_traction = volume * split_traction<Space>(d_sigma, g, m) + m(b, j) * (by_point + by_cell);
      for (int i = 0; i < cell.n_nodes(); ++i)
        sum.tangent.template block<dim, 1>(dim * i, dim * j + b) +=
            d_traction.col(i) - g(b, i) * by_point.col(j) - m(b, i) * by_cell.col(j);
    }
  }
}

/// Moves the points with the nodes and deforms them with their patch.
template <class Space>
void move_points(Body<Space>& body, const Eigen::VectorXd& displacement) {
  constexpr int dim = Space::dim;
  auto& points = body.points;
  for (const int cell : body.cells.occupied) {
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
}

} // namespace

/// The linear system, kept between increments for its pattern and its factorisation.
template <class Space>
struct QuasiStaticStep<Space>::System {
  static constexpr int dim = Space::dim;

  std::vector<int> equation; ///< as in Numbering
  TangentMatrix tangent;
  TangentSolver solver;

  explicit System(exchange::MpmLinearSolver kind) : solver(kind) {}

  void renumber(const Body<Space>& body) {
    Numbering numbering = number_unknowns(body);
    equation = std::move(numbering.equation);
    if (tangent.set_pattern(std::move(numbering.cells))) solver.forget();
  }

  /// Internal forces at `displacement`, and the tangent; false if a point turns inside out.
  bool assemble(const Body<Space>& body, const Eigen::VectorXd& displacement, Eigen::VectorXd& internal) {
    internal.setZero();
    tangent.set_zero();
    bool sound = true;
    std::size_t number = 0;
    for (const int cell : body.cells.occupied) {
      const CellGradients<Space> cell_gradients(body, cell);
      CellContribution<Space> sum;
      cell_gradients.for_each_patch([&](const Patch<Space>& patch) {
        const auto kinematics = kinematics_of(body, cell_gradients, patch, displacement);
        sound = sound && kinematics.volume_ratio > 0.0;
        if (!sound) return;
        if (body.mean_volume)
          add_patch_of_mean_volume(body, cell_gradients, patch, displacement, sum);
        else
          add_patch(body, cell_gradients, patch, kinematics, sum);
      });
      if (!sound) return false;
      for (int i = 0; i < cell_gradients.n_nodes(); ++i)
        internal.template segment<dim>(dim * cell_gradients.node(i)) += sum.force.template segment<dim>(dim * i);
      tangent.add(number++, sum.tangent);
    }
    return true;
  }

  /// The entries of a full nodal vector at the free degrees of freedom.
  [[nodiscard]] Eigen::VectorXd free_part(const Eigen::VectorXd& full) const {
    Eigen::VectorXd part(tangent.size());
    for (std::size_t dof = 0; dof < equation.size(); ++dof)
      if (const int row = equation[dof]; row >= 0) part[row] = full[static_cast<Eigen::Index>(dof)];
    return part;
  }

  void add_to_free(const Eigen::VectorXd& step, Eigen::VectorXd& full) const {
    for (std::size_t dof = 0; dof < equation.size(); ++dof)
      if (const int row = equation[dof]; row >= 0) full[static_cast<Eigen::Index>(dof)] += step[row];
  }
};

template <class Space>
QuasiStaticStep<Space>::QuasiStaticStep(double tolerance, exchange::MpmLinearSolver solver)
    : system_(std::make_unique<System>(solver)), tolerance_(tolerance) {}
template <class Space>
QuasiStaticStep<Space>::QuasiStaticStep(QuasiStaticStep&&) noexcept = default;
template <class Space>
QuasiStaticStep<Space>::~QuasiStaticStep() = default;

template <class Space>
IncrementReport QuasiStaticStep<Space>::advance(Body<Space>& body, const Gravity& gravity, double fraction,
                                                const Eigen::VectorXd& support_motion) {
  System& system = *system_;
  system.renumber(body);
  const Eigen::VectorXd external = external_forces(body, gravity);
  double scale = external.norm();
  Eigen::VectorXd internal(external.size()), displacement = Eigen::VectorXd::Zero(external.size()), target, step;

  IncrementReport report;
  for (int iteration = 0; iteration <= max_iterations; ++iteration) {
    if (!system.assemble(body, displacement, internal)) return report;
    if (iteration == 0) {
      target = internal + fraction * (external - internal);
      if (support_motion.size() > 0) displacement = support_motion;
      if (support_motion.size() > 0 && !system.assemble(body, displacement, internal)) return report;
      scale = std::max(scale, internal.norm()); // moved supports load as much as weight does
    }
    const Eigen::VectorXd residual = system.free_part(target - internal);
    report.residuals.push_back(scale > 0.0 ? residual.norm() / scale : 0.0);
    report.out_of_balance = report.residuals.back();
    report.converged = report.out_of_balance <= tolerance_;
    if (report.converged || iteration == max_iterations || !std::isfinite(report.out_of_balance)) break;
    ++report.linear_solves;
    const double accuracy = linear_tolerance(report.out_of_balance);
    if (!system.solver.solve(system.tangent.matrix(), residual, accuracy, step)) return report;
    system.add_to_free(step, displacement);
  }
  if (!report.converged) return report;
  report.base_reaction = base_reaction(body, internal, external);
  report.reactions = support_forces(body, internal, external);
  report.largest_displacement = displacement.template lpNorm<Eigen::Infinity>();
  move_points(body, displacement);
  body.sort();
  if (body.average_stress) replace_stress_by_cell_average(body);
  return report;
}

#define SETTLE_INSTANTIATE(Space) template class QuasiStaticStep<Space>;
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
