#include "sampling.hpp"

#include <deal.II/base/geometry_info.h>

#include <fmt/format.h>

#include "cell_terms.hpp"
#include "mesh.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::fem {
namespace {

template <int dim>
using Cell = typename StagedProblem<dim>::Cell;

template <int dim>
using Stress = dealii::SymmetricTensor<2, dim>;

template <int dim>
void append(std::vector<double>& values, const dealii::Tensor<1, dim>& vector) {
  for (unsigned c = 0; c < dim; ++c)
    values.push_back(vector[c]);
}

void append(std::vector<double>& values, const std::array<double, 6>& components) {
  values.insert(values.end(), components.begin(), components.end());
}

template <int dim>
Stress<dim> mean_stress(const StagedProblem<dim>& problem, const Cell<dim>& cell) {
  const auto& stress = problem.history().of(cell).stress;
  Stress<dim> mean;
  for (std::size_t q = 0; q < stress.size(); ++q)
    mean += problem.quadrature().weight(static_cast<unsigned>(q)) * stress[q];
  return mean;
}

/// The neighbour across a face if it belongs to the same layer, else the cell itself.
template <int dim>
Cell<dim> neighbour_in_layer(const Cell<dim>& cell, unsigned face) {
  if (cell->at_boundary(face) || layer_of(cell->neighbor(face)) != layer_of(cell)) return cell;
  return cell->neighbor(face);
}

/// Change of stress over one cell along an axis, from the means of cells.
template <int dim>
Stress<dim> slope_between_cells(const StagedProblem<dim>& problem, const Cell<dim>& cell, unsigned axis) {
  const Cell<dim> lower = neighbour_in_layer<dim>(cell, 2 * axis);
  const Cell<dim> upper = neighbour_in_layer<dim>(cell, 2 * axis + 1);
  const int cells_apart = (lower != cell) + (upper != cell);
  if (cells_apart == 0) return Stress<dim>();
  return (mean_stress(problem, upper) - mean_stress(problem, lower)) / cells_apart;
}

/// Change of stress over one cell along an axis, by least squares through its quadrature points.
template <int dim>
Stress<dim> slope_within_cell(const StagedProblem<dim>& problem, const Cell<dim>& cell, unsigned axis) {
  const auto& stress = problem.history().of(cell).stress;
  Stress<dim> first_moment;
  double second_moment = 0.0;
  for (unsigned q = 0; q < stress.size(); ++q) {
    const double arm = problem.quadrature().point(q)[axis] - 0.5;
    first_moment += problem.quadrature().weight(q) * arm * stress[q];
    second_moment += problem.quadrature().weight(q) * arm * arm;
  }
  return first_moment / second_moment;
}

template <int dim>
dealii::Point<dim> design_point(const exchange::ProbePoint& probe) {
  if constexpr (dim == 2)
    return {probe.x, probe.design_height};
  else
    return {probe.x, probe.y, probe.design_height};
}

/// A cell of the probe's own layer that holds it, on its boundary or within.
template <int dim>
Cell<dim> cell_around(const StagedProblem<dim>& problem, const exchange::ProbePoint& probe) {
  constexpr double slack = 1e-9; // of a cell's size: probes stand on cell boundaries up to round-off
  for (const auto& cell : problem.dofs().active_cell_iterators())
    if (layer_of(cell) == probe.layer && cell->bounding_box().point_inside(design_point<dim>(probe), slack))
      return cell;
  return problem.dofs().end();
}

exchange::InputError outside(const exchange::Case& study, const std::string& line, const exchange::ProbePoint& probe) {
  const exchange::Geometry& geometry = study.geometry;
  const bool in_space = geometry.dimension == 3;
  return exchange::InputError(
      exchange::Complaint{.where = study.where(fmt::format("probes.{}.x", line)),
                          .what = fmt::format("the line probes.{} stands outside the column", line),
                          .given = in_space ? fmt::format("x = {:.6g} m, y = {:.6g} m", probe.x, probe.y)
                                            : fmt::format("x = {:.6g} m", probe.x),
                          .allowed = in_space ? fmt::format("0 <= x <= {:.6g} m, 0 <= y <= {:.6g} m", geometry.width,
                                                            geometry.depth.value_or(geometry.width))
                                              : fmt::format("0 <= x <= {:.6g} m", geometry.width),
                          .remedy = "move the line, or leave its position out: then it stands in the middle"});
}

} // namespace

template <int dim>
exchange::SamplePoints native_points(const StagedProblem<dim>& problem) {
  exchange::SamplePoints points;
  dealii::FEValues<dim> values(problem.element(), problem.quadrature(),
                               dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points |
                                   dealii::update_JxW_values);
  std::vector<dealii::Tensor<1, dim>> displacement(values.n_quadrature_points);
  for (const Cell<dim>& cell : problem.placed_cells()) {
    values.reinit(cell);
    const CellHistory<dim>& history = problem.history().of(cell);
    values[displacements].get_function_values_from_local_dof_values(history.displacement, displacement);
    const auto strain = strains(values, history.displacement);
    for (const unsigned q : values.quadrature_point_indices()) {
      points.id.push_back(std::uint64_t{cell->active_cell_index()} * values.n_quadrature_points + q);
      points.layer.push_back(layer_of(cell));
      points.refilled.push_back(0);
      append(points.placed_position, values.quadrature_point(q));
      append(points.position, values.quadrature_point(q) + displacement[q]);
      append(points.displacement, displacement[q]);
      append(points.stress, six_components(history.stress[q], problem.law()));
      points.density.push_back(problem.density() / (1.0 + trace(strain[q])));
      points.volume.push_back(values.JxW(q));
    }
  }
  return points;
}

template <int dim>
dealii::Tensor<1, dim> displacement_at(const StagedProblem<dim>& problem, const Cell<dim>& cell,
                                       const dealii::Point<dim>& unit) {
  const std::vector<double>& at_dofs = problem.history().of(cell).displacement;
  dealii::Tensor<1, dim> displacement;
  for (unsigned i = 0; i < at_dofs.size(); ++i) {
    const unsigned component = problem.element().system_to_component_index(i).first;
    displacement[component] += at_dofs[i] * problem.element().shape_value(i, unit);
  }
  return displacement;
}

template <int dim>
dealii::SymmetricTensor<2, dim> stress_at(const StagedProblem<dim>& problem, const Cell<dim>& cell,
                                          const dealii::Point<dim>& unit) {
  const bool constant_in_cell = problem.element().degree == 1;
  Stress<dim> stress = mean_stress(problem, cell);
  for (unsigned axis = 0; axis < dim; ++axis)
    stress += (unit[axis] - 0.5) *
              (constant_in_cell ? slope_between_cells(problem, cell, axis) : slope_within_cell(problem, cell, axis));
  return stress;
}

template <int dim>
ProbeLines<dim>::ProbeLines(const StagedProblem<dim>& problem, const exchange::Case& study) {
  for (const auto& [name, line] : study.probes)
    for (const exchange::ProbePoint& point : exchange::probe_points(study, line)) {
      const Cell<dim> cell = cell_around(problem, point);
      if (cell == problem.dofs().end()) throw outside(study, name, point);
      const dealii::Point<dim> position = design_point<dim>(point);
      const dealii::Point<dim> unit = cell->bounding_box().real_to_unit(position);
      lines_[name].push_back({cell, position, dealii::GeometryInfo<dim>::project_to_unit_cell(unit)});
    }
}

template <int dim>
std::map<std::string, exchange::ProbeSamples> ProbeLines<dim>::sample(const StagedProblem<dim>& problem) const {
  std::map<std::string, exchange::ProbeSamples> lines;
  for (const auto& [name, probes] : lines_) {
    exchange::ProbeSamples& samples = lines[name];
    for (const Probe& probe : probes) {
      if (!problem.history().of(probe.cell).placed()) continue;
      samples.layer.push_back(layer_of(probe.cell));
      append(samples.design_position, probe.position);
      append(samples.placed_position, probe.position);
      append(samples.displacement, displacement_at(problem, probe.cell, probe.unit));
      append(samples.stress, six_components(stress_at(problem, probe.cell, probe.unit), problem.law()));
    }
  }
  return lines;
}

#define SETTLE_INSTANTIATE(dim)                                                                                        \
  template exchange::SamplePoints native_points(const StagedProblem<dim>&);                                            \
  template dealii::Tensor<1, dim> displacement_at(const StagedProblem<dim>&, const Cell<dim>&,                         \
                                                  const dealii::Point<dim>&);                                          \
  template dealii::SymmetricTensor<2, dim> stress_at(const StagedProblem<dim>&, const Cell<dim>&,                      \
                                                     const dealii::Point<dim>&);                                       \
  template class ProbeLines<dim>;
SETTLE_INSTANTIATE(2)
SETTLE_INSTANTIATE(3)
#undef SETTLE_INSTANTIATE

} // namespace settle::fem
