#include "pictures.hpp"

#include <array>
#include <fstream>
#include <functional>

#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/numerics/data_out.h>

#include <fmt/format.h>

#include "elasticity.hpp"
#include "mesh.hpp"
#include "recovery.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::fem {
namespace {

constexpr std::array stress_names{"stress_xx", "stress_yy", "stress_zz", "stress_xy", "stress_yz", "stress_xz"};

void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& body) {
  std::ofstream stream(file);
  if (stream) body(stream);
  stream.close();
  if (stream) return;
  throw exchange::FileError(exchange::Complaint{
      .where = file.string(),
      .what = "the picture file cannot be written",
      .given = "--vtu " + file.parent_path().string(),
      .allowed = "a folder on a disk with free space where you may write",
      .remedy = "choose another folder with --vtu",
  });
}

template <int dim>
struct Fields {
  dealii::Vector<double> displacement;
  dealii::Vector<double> layer;
  std::array<dealii::Vector<double>, 6> stress;
};

template <int dim>
Fields<dim> fields_of(const StagedProblem<dim>& problem, const dealii::DoFHandler<dim>& broken) {
  const unsigned n_cells = broken.get_triangulation().n_active_cells();
  Fields<dim> fields{dealii::Vector<double>(broken.n_dofs()), dealii::Vector<double>(n_cells), {}};
  fields.stress.fill(dealii::Vector<double>(n_cells));
  dealii::Point<dim> middle;
  for (unsigned axis = 0; axis < dim; ++axis)
    middle[axis] = 0.5;
  const dealii::FiniteElement<dim>& element = broken.get_fe();
  dealii::Vector<double> at_dofs(element.n_dofs_per_cell());
  for (const auto& cell : problem.placed_cells()) {
    for (unsigned i = 0; i < at_dofs.size(); ++i)
      at_dofs[i] =
          displacement_at(problem, cell, element.unit_support_point(i))[element.system_to_component_index(i).first];
    const typename dealii::DoFHandler<dim>::active_cell_iterator broken_cell(&broken.get_triangulation(), cell->level(),
                                                                             cell->index(), &broken);
    broken_cell->set_dof_values(at_dofs, fields.displacement);
    fields.layer[cell->active_cell_index()] = layer_of(cell);
    const auto stress = six_components(stress_at(problem, cell, middle));
    for (std::size_t c = 0; c < 6; ++c)
      fields.stress[c][cell->active_cell_index()] = stress[c];
  }
  return fields;
}

} // namespace

template <int dim>
PictureSeries<dim>::PictureSeries(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code failure;
  std::filesystem::create_directories(folder_, failure);
  if (failure)
    throw exchange::FileError(
        exchange::Complaint{.where = folder_.string(),
                            .what = "the folder for pictures cannot be made: " + failure.message(),
                            .given = "--vtu " + folder_.string(),
                            .allowed = "a folder that exists, or can be made",
                            .remedy = "choose another folder with --vtu"});
}

template <int dim>
void PictureSeries<dim>::add(const StagedProblem<dim>& problem, int stage) {
  const dealii::FESystem<dim> element(dealii::FE_DGQ<dim>(problem.element().degree), dim);
  dealii::DoFHandler<dim> broken(problem.dofs().get_triangulation());
  broken.distribute_dofs(element);
  const Fields<dim> fields = fields_of(problem, broken);

  dealii::DataOut<dim> out;
  out.set_cell_selection([&problem](const typename dealii::Triangulation<dim>::cell_iterator& cell) {
    return problem.history().of(cell).placed();
  });
  out.attach_dof_handler(broken);
  using dealii::DataComponentInterpretation::component_is_part_of_vector;
  out.add_data_vector(
      fields.displacement, std::vector<std::string>(dim, "displacement"), dealii::DataOut<dim>::type_dof_data,
      std::vector<dealii::DataComponentInterpretation::DataComponentInterpretation>(dim, component_is_part_of_vector));
  out.add_data_vector(fields.layer, "layer", dealii::DataOut<dim>::type_cell_data);
  for (std::size_t c = 0; c < 6; ++c)
    out.add_data_vector(fields.stress[c], stress_names[c], dealii::DataOut<dim>::type_cell_data);
  out.build_patches(problem.mapping(), problem.element().degree, dealii::DataOut<dim>::curved_inner_cells);

  stages_.emplace_back(stage, fmt::format("stage_{:04}.vtu", stage));
  write_file(folder_ / stages_.back().second, [&](std::ostream& stream) { out.write_vtu(stream); });
  write_file(folder_ / "stages.pvd",
             [&](std::ostream& stream) { dealii::DataOutBase::write_pvd_record(stream, stages_); });
}

template class PictureSeries<2>;
template class PictureSeries<3>;

} // namespace settle::fem
