/// \file
/// Small strain: sigma += D : d(eps), all integrals over the cell as designed.
#pragma once

#include "elasticity.hpp"
#include "formulation.hpp"

namespace settle::fem {

template <int dim>
class SmallStrain final : public Formulation<dim> {
public:
  using typename Formulation<dim>::Stress;

  /// Of each layer.
  explicit SmallStrain(std::vector<Elasticity> constants) : constants_(std::move(constants)) {}

  [[nodiscard]] std::optional<std::vector<Stress>> stress(const Trial<dim>& trial) const override;
  [[nodiscard]] dealii::Vector<double> internal_force(const Trial<dim>& trial,
                                                      const std::vector<Stress>& stress) const override;
  [[nodiscard]] dealii::FullMatrix<double> tangent(const Trial<dim>& trial) const override;
  [[nodiscard]] bool linear() const override { return true; }
  [[nodiscard]] bool symmetric() const override { return true; }
  [[nodiscard]] bool frozen() const override { return true; }
  /// Density by 1 + tr eps; the volume is that of the frozen geometry.
  [[nodiscard]] std::vector<Measure> measures(const dealii::FEValues<dim>& values,
                                              const CellHistory<dim>& history) const override;

private:
  std::vector<Elasticity> constants_; ///< (layers)
};

} // namespace settle::fem
