/// \file
/// Small strain of soils: any soil law, by layer, over the cell as designed.
#pragma once

#include <vector>

#include "formulation.hpp"
#include "settle/exchange/case.hpp"
#include "soil/soil_law.hpp"

namespace settle::fem {

template <int dim>
class SoilStrain final : public Formulation<dim> {
public:
  using typename Formulation<dim>::Stress;

  /// The law of each layer, those numbered from 1.
  SoilStrain(std::vector<SoilLaw> laws, exchange::FemIntegration integration)
      : laws_(std::move(laws)), integration_(integration) {}

  [[nodiscard]] std::optional<std::vector<Stress>> stress(const Trial<dim>& trial) const override;
  [[nodiscard]] std::vector<StateVariables> variables(const Trial<dim>& trial) const override;
  [[nodiscard]] dealii::Vector<double> internal_force(const Trial<dim>& trial,
                                                      const std::vector<Stress>& stress) const override;
  [[nodiscard]] dealii::FullMatrix<double> tangent(const Trial<dim>& trial) const override;
  [[nodiscard]] dealii::FullMatrix<double> elastic_stiffness(const Trial<dim>& trial) const override;
  [[nodiscard]] bool linear() const override;
  [[nodiscard]] bool symmetric() const override { return linear(); }
  /// Density by 1 + tr eps; the volume is that of the frozen geometry.
  [[nodiscard]] std::vector<Measure> measures(const dealii::FEValues<dim>& values,
                                              const CellHistory<dim>& history) const override;

private:
  /// (quadrature points); nothing where a law has no answer.
  [[nodiscard]] std::optional<std::vector<SoilResponse>> responses(const Trial<dim>& trial) const;

  std::vector<SoilLaw> laws_;
  exchange::FemIntegration integration_;
};

} // namespace settle::fem
