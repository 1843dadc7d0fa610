#include "sampling.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include <deal.II/base/geometry_info.h>
#include <deal.II/fe/mapping_q1.h>

#include "cell_terms.hpp"
#include "elasticity.hpp"
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

/// Where in a cell as designed a point lies, on its boundary or within, in unit coordinates; nothing where it lies
/// outside.
template <int dim>
std::optional<dealii::Point<dim>> place_within(const Cell<dim>& cell, const dealii::Point<dim>& point) {
  // Of a cell's size. Probes may lie outside polygons by 1e-9 of the extent, which 1e4 cells or fewer divide.
  constexpr double slack = 1e-5;
  if (!cell->bounding_box().point_inside(point, slack)) return {};
  try {
    const dealii::Point<dim> unit = dealii::StaticMappingQ1<dim>::mapping.transform_real_to_unit_cell(cell, point);
    if (!dealii::GeometryInfo<dim>::is_inside_unit_cell(unit, slack)) return {};
    return dealii::GeometryInfo<dim>::project_to_unit_cell(unit);
  } catch (const typename dealii::Mapping<dim>::ExcTransformationFailed&) {
    return {}; // beside the cell, where its map has no inverse
  }
}

} // namespace

template <int dim>
exchange::SamplePoints native_points(const StagedProblem<dim>& problem) {
  exchange::SamplePoints points;
  dealii::FEValues<dim> values(problem.mapping(), problem.element(), problem.quadrature(),
                               dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points |
                                   dealii::update_JxW_values);
  std::vector<dealii::Tensor<1, dim>> displacement(values.n_quadrature_points), datum(values.n_quadrature_points);
  for (const Cell<dim>& cell : problem.placed_cells()) {
    values.reinit(cell);
    const CellHistory<dim>& history = problem.history().of(cell);
    values[displacements].get_function_values_from_local_dof_values(history.counted_displacement(), displacement);
    if (problem.geometry_moves()) values[displacements].get_function_values_from_local_dof_values(history.datum, datum);
    const std::vector<Measure> measures = problem.formulation().measures(values, history);
    for (const unsigned q : values.quadrature_point_indices()) {
      points.id.push_back(std::uint64_t{cell->active_cell_index()} * values.n_quadrature_points + q);
      points.layer.push_back(layer_of(cell));
      points.refilled.push_back(0);
      const dealii::Point<dim> placed = values.quadrature_point(q) + datum[q];
      append(points.placed_position, placed);
      append(points.position, placed + displacement[q]);
      append(points.displacement, displacement[q]);
      append(points.stress, six_components(history.stress[q]));
      if (problem.yields()) points.plastic_strain.push_back(history.variables[q].plastic_strain);
      if (problem.hardens()) points.preconsolidation_pressure.push_back(history.variables[q].preconsolidation_pressure);
      points.density.push_back(problem.density(layer_of(cell)) * measures[q].density_ratio);
      points.volume.push_back(values.JxW(q) * measures[q].volume_ratio);
    }
  }
  return points;
}

template <int dim>
ProbeLines<dim>::ProbeLines(const StagedProblem<dim>& problem, const exchange::Case& study) {
  for (const auto& [name, line] : study.probes)
    for (const exchange::ProbePoint& point : exchange::probe_points(study, line))
      lines_[name].push_back(tie(problem, point));
}

/// To a cell of the probe's own layer.
template <int dim>
auto ProbeLines<dim>::tie(const StagedProblem<dim>& problem, const exchange::ProbePoint& point) -> Probe {
  const dealii::Point<dim> designed = design_point<dim>(point);
  for (const auto& cell : problem.dofs().active_cell_iterators()) {
    if (layer_of(cell) != point.layer) continue;
    if (const auto unit = place_within<dim>(cell, designed)) return {cell, designed, *unit};
  }
  SETTLE_ASSERT(false, point.layer, point.x, point.y, point.design_height);
  return {problem.dofs().end(), designed, {}};
}

/// Where geometry is frozen, that of the design.
template <int dim>
double highest_point(const StagedProblem<dim>& problem) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const Cell<dim>& cell : problem.placed_cells())
    for (const unsigned v : cell->vertex_indices()) {
      const dealii::Point<dim> unit = dealii::GeometryInfo<dim>::unit_cell_vertex(v);
      double height = placed_position_at(problem, cell, unit)[dim - 1];
      if (problem.geometry_moves()) height += displacement_at(problem, cell, unit)[dim - 1];
      highest = std::max(highest, height);
    }
  return highest;
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
      append(samples.placed_position, placed_position_at(problem, probe.cell, probe.unit));
      append(samples.displacement, displacement_at(problem, probe.cell, probe.unit));
      append(samples.stress, six_components(stress_at(problem, probe.cell, probe.unit)));
    }
  }
  return lines;
}

template exchange::SamplePoints native_points(const StagedProblem<2>&);
template exchange::SamplePoints native_points(const StagedProblem<3>&);
template double highest_point(const StagedProblem<2>&);
template double highest_point(const StagedProblem<3>&);
template class ProbeLines<2>;
template class ProbeLines<3>;

} // namespace settle::fem
