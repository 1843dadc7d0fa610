#include "finite_strain.hpp"

#include "finite_cell_terms.hpp"
#include "finite_laws.hpp"
#include "left_stretch.hpp"
#include "space.hpp"

namespace settle::fem {
namespace {

/// (quadrature points) the motion of a cell's points, and F in the dimension of the problem.
template <int dim>
struct Motions {
  std::vector<PointMotion> in_space;
  std::vector<dealii::Tensor<2, dim>> motion;
};

template <int dim>
Motions<dim> motions(const Trial<dim>& trial) {
  const auto before = gradients(trial.values, trial.history.displacement);
  const auto increment = gradients(trial.values, trial.increment);
  const auto after = gradients(trial.values, trial.displacement());
  const dealii::Tensor<2, dim> identity(dealii::unit_symmetric_tensor<dim>());
  Motions<dim> motions;
  for (std::size_t q = 0; q < before.size(); ++q) {
    motions.in_space.push_back(
        {in_space<dim>(before[q]), in_space<dim>(increment[q]), in_space<dim>(after[q]), trial.history.stress[q]});
    motions.motion.push_back(identity + after[q]);
  }
  return motions;
}

} // namespace

template <int dim>
auto FiniteStrain<dim>::stress(const Trial<dim>& trial) const -> std::optional<std::vector<Stress>> {
  const auto& [law, constants] = of_layer(laws_, trial.layer);
  std::vector<Stress> stress;
  for (const PointMotion& motion : motions(trial).in_space) {
    const std::optional<PointResponse> response = respond(law, constants, motion, Wanted::stress);
    if (!response) return {};
    stress.push_back(response->kirchhoff / response->volume_ratio);
  }
  return stress;
}

template <int dim>
dealii::Vector<double> FiniteStrain<dim>::internal_force(const Trial<dim>& trial,
                                                         const std::vector<Stress>& stress) const {
  const std::vector<dealii::Tensor<2, dim>> motion = motions(trial).motion;
  std::vector<DeformedPoint<dim>> points(stress.size());
  for (std::size_t q = 0; q < points.size(); ++q)
    points[q] = {invert(motion[q]), determinant(motion[q]) * in_plane<dim>(stress[q]), {}};
  return fem::internal_force(trial.values, points);
}

template <int dim>
dealii::FullMatrix<double> FiniteStrain<dim>::tangent(const Trial<dim>& trial) const {
  const auto& [law, constants] = of_layer(laws_, trial.layer);
  const Motions<dim> all = motions(trial);
  std::vector<DeformedPoint<dim>> points(all.motion.size());
  for (std::size_t q = 0; q < points.size(); ++q) {
    const PointResponse response = respond(law, constants, all.in_space[q]).value();
    points[q] = {invert(all.motion[q]), in_plane<dim>(response.kirchhoff), in_plane<dim>(response.moduli)};
  }
  return tangent_matrix(trial.values, points);
}

template <int dim>
std::vector<Measure> FiniteStrain<dim>::measures(const dealii::FEValues<dim>& values,
                                                 const CellHistory<dim>& history) const {
  std::vector<Measure> measures;
  for (const auto& gradient : gradients(values, history.displacement)) {
    const double volume_ratio = 1.0 + volume_change(in_space<dim>(gradient));
    measures.push_back({.density_ratio = 1.0 / volume_ratio, .volume_ratio = volume_ratio});
  }
  return measures;
}

template class FiniteStrain<2>;
template class FiniteStrain<3>;

} // namespace settle::fem
