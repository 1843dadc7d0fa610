/// \file
/// Finite strain: total Lagrangian, every cell relative to the geometry in which it was placed.
#pragma once

#include <algorithm>
#include <vector>

#include "elasticity.hpp"
#include "formulation.hpp"
#include "settle/exchange/case.hpp"

namespace settle::fem {

struct FiniteLaw {
  exchange::Law law;
  Elasticity constants;
};

template <int dim>
class FiniteStrain final : public Formulation<dim> {
public:
  using typename Formulation<dim>::Stress;

  /// Of each layer.
  explicit FiniteStrain(std::vector<FiniteLaw> laws) : laws_(std::move(laws)) {}

  [[nodiscard]] std::optional<std::vector<Stress>> stress(const Trial<dim>& trial) const override;
  [[nodiscard]] dealii::Vector<double> internal_force(const Trial<dim>& trial,
                                                      const std::vector<Stress>& stress) const override;
  [[nodiscard]] dealii::FullMatrix<double> tangent(const Trial<dim>& trial) const override;
  [[nodiscard]] bool linear() const override { return false; }
  [[nodiscard]] bool symmetric() const override {
    return std::none_of(laws_.begin(), laws_.end(),
                        [](const FiniteLaw& law) { return law.law == exchange::Law::rate; });
  }
  [[nodiscard]] bool frozen() const override { return false; }
  [[nodiscard]] std::vector<Measure> measures(const dealii::FEValues<dim>& values,
                                              const CellHistory<dim>& history) const override;

private:
  std::vector<FiniteLaw> laws_; ///< (layers)
};

} // namespace settle::fem
