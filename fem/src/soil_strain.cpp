#include "soil_strain.hpp"

#include <algorithm>

#include "shape_strains.hpp"
#include "space.hpp"

namespace settle::fem {

template <int dim>
std::optional<std::vector<SoilResponse>> SoilStrain<dim>::responses(const Trial<dim>& trial) const {
  const SoilLaw& law = laws_.at(static_cast<std::size_t>(trial.layer - 1));
  std::vector<SoilResponse> responses;
  for (const auto& strain : ShapeStrains<dim>(trial.values, integration_).strains(trial.increment)) {
    const std::size_t q = responses.size();
    const auto in_all_axes = symmetrize(in_space<dim>(dealii::Tensor<2, dim>(strain)));
    const auto response = respond(law, {trial.history.stress[q], trial.history.variables[q]}, in_all_axes);
    if (!response) return {};
    responses.push_back(*response);
  }
  return responses;
}

template <int dim>
auto SoilStrain<dim>::stress(const Trial<dim>& trial) const -> std::optional<std::vector<Stress>> {
  const auto responses = this->responses(trial);
  if (!responses) return {};
  std::vector<Stress> stress;
  for (const SoilResponse& response : *responses)
    stress.push_back(response.point.stress);
  return stress;
}

template <int dim>
std::vector<StateVariables> SoilStrain<dim>::variables(const Trial<dim>& trial) const {
  const std::vector<SoilResponse> responses = this->responses(trial).value();
  std::vector<StateVariables> variables;
  for (const SoilResponse& response : responses)
    variables.push_back(response.point.variables);
  return variables;
}

template <int dim>
dealii::Vector<double> SoilStrain<dim>::internal_force(const Trial<dim>& trial,
                                                       const std::vector<Stress>& stress) const {
  std::vector<dealii::SymmetricTensor<2, dim>> acting;
  for (const Stress& tensor : stress)
    acting.push_back(in_plane<dim>(tensor));
  return ShapeStrains<dim>(trial.values, integration_).internal_force(acting);
}

template <int dim>
dealii::FullMatrix<double> SoilStrain<dim>::tangent(const Trial<dim>& trial) const {
  const std::vector<SoilResponse> responses = this->responses(trial).value();
  std::vector<dealii::SymmetricTensor<4, dim>> moduli;
  for (const SoilResponse& response : responses)
    moduli.push_back(in_plane<dim>(response.tangent));
  return ShapeStrains<dim>(trial.values, integration_).stiffness_matrix(moduli);
}

template <int dim>
dealii::FullMatrix<double> SoilStrain<dim>::elastic_stiffness(const Trial<dim>& trial) const {
  const SoilLaw& law = of_layer(laws_, trial.layer);
  std::vector<dealii::SymmetricTensor<4, dim>> moduli;
  for (std::size_t q = 0; q < trial.history.stress.size(); ++q)
    moduli.push_back(in_plane<dim>(fem::elastic_stiffness(law, {trial.history.stress[q], trial.history.variables[q]})));
  return ShapeStrains<dim>(trial.values, integration_).stiffness_matrix(moduli);
}

template <int dim>
bool SoilStrain<dim>::linear() const {
  return std::all_of(laws_.begin(), laws_.end(),
                     [](const SoilLaw& law) { return std::holds_alternative<Elasticity>(law); });
}

template <int dim>
std::vector<Measure> SoilStrain<dim>::measures(const dealii::FEValues<dim>& values,
                                               const CellHistory<dim>& history) const {
  std::vector<Measure> measures;
  for (const auto& strain : ShapeStrains<dim>(values, integration_).strains(history.displacement))
    measures.push_back({.density_ratio = 1.0 / (1.0 + trace(strain)), .volume_ratio = 1.0});
  return measures;
}

template class SoilStrain<2>;
template class SoilStrain<3>;

} // namespace settle::fem
