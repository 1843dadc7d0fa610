#include "cell_contribution.hpp"

#include "constitutive_update.hpp"
#include "mean_volume.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

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

} // namespace

template <class Space>
IncrementalKinematics<Space::dim> kinematics_of(const Body<Space>& body, const CellGradients<Space>& cell,
                                                const Patch<Space>& patch, const Eigen::VectorXd& displacement) {
  const Tensor<Space::dim> own = gradient_of(cell, patch.gradients, displacement);
  if (!body.mean_volume) return IncrementalKinematics<Space::dim>(own);
  return IncrementalKinematics<Space::dim>(
      with_volume_of<Space::dim>(own, gradient_of(cell, cell.mean_gradients(), displacement)));
}

template <class Space>
bool contribute(const Body<Space>& body, const CellGradients<Space>& cell, const Eigen::VectorXd& displacement,
                CellContribution<Space>& sum) {
  sum.force.setZero();
  sum.tangent.setZero();
  bool sound = true;
  cell.for_each_patch([&](const Patch<Space>& patch) {
    const auto kinematics = kinematics_of(body, cell, patch, displacement);
    sound = sound && kinematics.volume_ratio > 0.0;
    if (!sound) return;
    if (body.mean_volume)
      add_patch_of_mean_volume(body, cell, patch, displacement, sum);
    else
      add_patch(body, cell, patch, kinematics, sum);
  });
  return sound;
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template IncrementalKinematics<Space::dim> kinematics_of(const Body<Space>&, const CellGradients<Space>&,            \
                                                           const Patch<Space>&, const Eigen::VectorXd&);               \
  template bool contribute(const Body<Space>&, const CellGradients<Space>&, const Eigen::VectorXd&,                    \
                           CellContribution<Space>&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm
