/// \file
/// What distinguishes small from finite strain: how a cell's stress, nodal forces and tangent follow from its motion.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "history.hpp"

namespace settle::fem {

/// A cell in an increment that is not accepted yet.
template <int dim>
struct Trial {
  const dealii::FEValues<dim>& values; ///< on the cell as placed
  const CellHistory<dim>& history;
  std::vector<double> increment; ///< (dofs) of displacement [m]
  int layer = 1;                 ///< whose material it is

  /// (dofs) since placement, at the end of the increment [m].
  [[nodiscard]] std::vector<double> displacement() const {
    std::vector<double> displacement = history.displacement;
    std::transform(displacement.begin(), displacement.end(), increment.begin(), displacement.begin(), std::plus<>());
    return displacement;
  }
};

/// How much room the material at a quadrature point takes.
struct Measure {
  double density_ratio; ///< current density over that as placed
  double volume_ratio;  ///< volume the solver gives it over that as placed
};

/// What is given for each layer, for one of them; layers are numbered from 1.
template <class Value>
const Value& of_layer(const std::vector<Value>& values, int layer) {
  return values.at(static_cast<std::size_t>(layer - 1));
}

template <int dim>
class Formulation {
public:
  using Stress = dealii::SymmetricTensor<2, 3>;

  Formulation() = default;
  Formulation(const Formulation&) = delete;
  Formulation& operator=(const Formulation&) = delete;
  virtual ~Formulation() = default;

  /// (quadrature points) Cauchy stress [Pa]; nothing where a point is turned inside out.
  [[nodiscard]] virtual std::optional<std::vector<Stress>> stress(const Trial<dim>& trial) const = 0;
  /// (quadrature points) what the soil remembers at the end of the increment. The trial must have a stress.
  [[nodiscard]] virtual std::vector<StateVariables> variables(const Trial<dim>& trial) const {
    return trial.history.variables;
  }
  /// (dofs) internal force of that stress [N].
  [[nodiscard]] virtual dealii::Vector<double> internal_force(const Trial<dim>& trial,
                                                              const std::vector<Stress>& stress) const = 0;
  /// (dofs, dofs) its derivative by the increment [N/m]. The trial must have a stress.
  [[nodiscard]] virtual dealii::FullMatrix<double> tangent(const Trial<dim>& trial) const = 0;
  /// (dofs, dofs) what the tangent is as long as nothing yields, in the accepted state [N/m].
  [[nodiscard]] virtual dealii::FullMatrix<double> elastic_stiffness(const Trial<dim>& trial) const {
    return tangent(trial);
  }
  /// Whether the tangent is the same in every state, so that once a stage is enough.
  [[nodiscard]] virtual bool linear() const = 0;
  /// Whether the tangent is symmetric in every state.
  [[nodiscard]] virtual bool symmetric() const = 0;
  /// (quadrature points) in the accepted state.
  [[nodiscard]] virtual std::vector<Measure> measures(const dealii::FEValues<dim>& values,
                                                      const CellHistory<dim>& history) const = 0;
};

} // namespace settle::fem
