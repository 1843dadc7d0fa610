#include "sampling.hpp"

#include <deal.II/base/geometry_info.h>

#include "cell_terms.hpp"
#include "mesh.hpp"
#include "recovery.hpp"
#include "settle/exchange/assert.hpp"

namespace settle::fem {
namespace {

template <int dim>
using Cell = typename StagedProblem<dim>::Cell;

template <int dim>
void append(std::vector<double>& values, const dealii::Tensor<1, dim>& vector) {
  for (unsigned c = 0; c < dim; ++c)
    values.push_back(vector[c]);
}

void append(std::vector<double>& values, const std::array<double, 6>& components) {
  values.insert(values.end(), components.begin(), components.end());
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

} // namespace

template <int dim>
exchange::SamplePoints native_points(const StagedProblem<dim>& problem) {
  exchange::SamplePoints points;
  dealii::FEValues<dim> values(problem.mapping(), problem.element(), problem.quadrature(),
                               dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points |
                                   dealii::update_JxW_values);
  std::vector<dealii::Tensor<1, dim>> displacement(values.n_quadrature_points);
  for (const Cell<dim>& cell : problem.placed_cells()) {
    values.reinit(cell);
    const CellHistory<dim>& history = problem.history().of(cell);
    values[displacements].get_function_values_from_local_dof_values(history.displacement, displacement);
    const std::vector<Measure> measures = problem.formulation().measures(values, history);
    for (const unsigned q : values.quadrature_point_indices()) {
      points.id.push_back(std::uint64_t{cell->active_cell_index()} * values.n_quadrature_points + q);
      points.layer.push_back(layer_of(cell));
      points.refilled.push_back(0);
      append(points.placed_position, values.quadrature_point(q));
      append(points.position, values.quadrature_point(q) + displacement[q]);
      append(points.displacement, displacement[q]);
      append(points.stress, six_components(history.stress[q]));
      points.density.push_back(problem.density() * measures[q].density_ratio);
      points.volume.push_back(values.JxW(q) * measures[q].volume_ratio);
    }
  }
  return points;
}

template <int dim>
ProbeLines<dim>::ProbeLines(const StagedProblem<dim>& problem, const exchange::Case& study) {
  for (const auto& [name, line] : study.probes)
    for (const exchange::ProbePoint& point : exchange::probe_points(study, line)) {
      const Cell<dim> cell = cell_around(problem, point);
      SETTLE_ASSERT(cell != problem.dofs().end(), name, point.layer, point.x, point.y, point.design_height);
      const dealii::Point<dim> designed = design_point<dim>(point);
      const dealii::Point<dim> unit = cell->bounding_box().real_to_unit(designed);
      lines_[name].push_back({cell, designed, dealii::GeometryInfo<dim>::project_to_unit_cell(unit)});
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
      append(samples.design_position, probe.designed);
      append(samples.placed_position, problem.mapping().transform_unit_to_real_cell(probe.cell, probe.unit));
      append(samples.displacement, displacement_at(problem, probe.cell, probe.unit));
      append(samples.stress, six_components(stress_at(problem, probe.cell, probe.unit)));
    }
  }
  return lines;
}

template exchange::SamplePoints native_points(const StagedProblem<2>&);
template exchange::SamplePoints native_points(const StagedProblem<3>&);
template class ProbeLines<2>;
template class ProbeLines<3>;

} // namespace settle::fem
