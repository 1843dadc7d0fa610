/// \file
/// Finite strain: total Lagrangian, every cell relative to the geometry in which it was placed.
#pragma once

#include "elasticity.hpp"
#include "formulation.hpp"
#include "settle/exchange/case.hpp"

namespace settle::fem {

template <int dim>
class FiniteStrain final : public Formulation<dim> {
public:
  using typename Formulation<dim>::Stress;

  FiniteStrain(exchange::Law law, const Elasticity& constants) : law_(law), constants_(constants) {}

  [[nodiscard]] std::optional<std::vector<Stress>> stress(const Trial<dim>& trial) const override;
  [[nodiscard]] dealii::Vector<double> internal_force(const Trial<dim>& trial,
                                                      const std::vector<Stress>& stress) const override;
  [[nodiscard]] dealii::FullMatrix<double> tangent(const Trial<dim>& trial) const override;
  [[nodiscard]] bool linear() const override { return false; }
  [[nodiscard]] bool symmetric() const override { return law_ != exchange::Law::rate; }
  [[nodiscard]] std::vector<Measure> measures(const dealii::FEValues<dim>& values,
                                              const CellHistory<dim>& history) const override;

private:
  exchange::Law law_;
  Elasticity constants_;
};

} // namespace settle::fem
