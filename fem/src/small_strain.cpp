#include "small_strain.hpp"

#include "cell_terms.hpp"
#include "space.hpp"

namespace settle::fem {

template <int dim>
auto SmallStrain<dim>::stress(const Trial<dim>& trial) const -> std::optional<std::vector<Stress>> {
  const Elasticity& constants = of_layer(constants_, trial.layer);
  std::vector<Stress> stress = trial.history.stress;
  const auto increments = strains(trial.values, trial.increment);
  for (std::size_t q = 0; q < stress.size(); ++q)
    stress[q] += hooke(constants, symmetrize(in_space<dim>(dealii::Tensor<2, dim>(increments[q]))));
  return stress;
}

template <int dim>
dealii::Vector<double> SmallStrain<dim>::internal_force(const Trial<dim>& trial,
                                                        const std::vector<Stress>& stress) const {
  std::vector<dealii::SymmetricTensor<2, dim>> acting;
  for (const Stress& tensor : stress)
    acting.push_back(in_plane<dim>(tensor));
  return fem::internal_force(trial.values, acting);
}

template <int dim>
dealii::FullMatrix<double> SmallStrain<dim>::tangent(const Trial<dim>& trial) const {
  return stiffness_matrix(trial.values, stiffness<dim>(of_layer(constants_, trial.layer)));
}

template <int dim>
std::vector<Measure> SmallStrain<dim>::measures(const dealii::FEValues<dim>& values,
                                                const CellHistory<dim>& history) const {
  std::vector<Measure> measures;
  for (const auto& strain : strains(values, history.displacement))
    measures.push_back({.density_ratio = 1.0 / (1.0 + trace(strain)), .volume_ratio = 1.0});
  return measures;
}

template class SmallStrain<2>;
template class SmallStrain<3>;

} // namespace settle::fem
