#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command.hpp"
#include "settle/compare/column_law.hpp"
#include "settle/compare/exact_column.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/mesh_geometry.hpp"
#include "settle/exchange/plane_geometry.hpp"
#include "settle/exchange/valley.hpp"

namespace settle::compare::cli {
namespace {

std::string exact_figures(const exchange::Case& study, exchange::Kinematics kinematics, const std::string& who) {
  const ExactColumn column(study, kinematics);
  const int last = study.construction.layers;
  return fmt::format("# exact, what {} solves ({} kinematics):\n"
                     "#   largest settlement {:.6f} m, base stress {:.3f} kPa, mean density {:.1f} kg/m3, "
                     "surface at {:.6f} m\n",
                     who, exchange::name_of(kinematics), column.largest_settlement(last),
                     column.base_stress(last) / 1e3, column.mean_density(last), column.surface_height(last));
}

std::string size_of_layer(const exchange::Geometry& geometry, int layer) {
  if (geometry.valley) return fmt::format("{:.6g} m3", exchange::layer_volume(geometry, layer));
  if (geometry.solid_mesh()) return fmt::format("{:.6g} m3", exchange::layer_volume(*geometry.mesh, layer));
  return fmt::format("{:.6g} m2", exchange::layer_area(geometry, layer));
}

/// Its cells, and what checks call its supports.
std::string figures_of_mesh(const exchange::Case& study) {
  const exchange::Mesh& mesh = *study.geometry.mesh;
  std::string text = fmt::format("# mesh: {} cells of {:.4g} m on average, {} nodes\n", mesh.cells.size(),
                                 study.fem.element_size, mesh.nodes.size());
  for (std::size_t i = 0; i < study.supports.size(); ++i) {
    const exchange::Support& support = study.supports[i];
    text += fmt::format("# support {}: {}, ({:.6g}) to ({:.6g})\n", i + 1, support.boundary,
                        fmt::join(support.from, ", "), fmt::join(support.to, ", "));
  }
  return text;
}

std::string figures_of_body(const exchange::Case& study) {
  std::string text = fmt::format("# constrained modulus M = {:.6g} Pa\n# unit weight gamma_0 = {:.6g} N/m3\n",
                                 ColumnLaw(study.fill()).constrained_modulus(), study.fill().density * study.gravity);
  for (int layer = 1; layer <= study.construction.layers; ++layer)
    text += fmt::format("# layer {}: {}\n", layer, size_of_layer(study.geometry, layer));
  if (study.geometry.mesh) text += figures_of_mesh(study);
  return text;
}

/// Without the text of its mesh, which is in a file.
std::string shown(exchange::Case study) {
  if (study.geometry.mesh) study.geometry.mesh->text.clear();
  return exchange::to_toml(study);
}

/// As TOML comments, so that what is shown is a case file.
std::string derived_figures(const exchange::Case& study) {
  if (study.geometry.drawn()) return figures_of_body(study);
  const double height = study.geometry.height;
  std::string text = fmt::format("# constrained modulus M = {:.6g} Pa\n# unit weight gamma_0 = {:.6g} N/m3\n"
                                 "# layer thickness {:.6g} m\n# Eq. (1), largest settlement {:.6f} m\n",
                                 ColumnLaw(study.fill()).constrained_modulus(), study.fill().density * study.gravity,
                                 study.layer_thickness(), equation_1(study, study.fill().density, height / 2.0));
  text += exact_figures(study, exchange::Kinematics::finite, "mpm");
  return text + exact_figures(study, study.fem.kinematics, "fem");
}

class ShowCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "show"; }
  [[nodiscard]] std::string purpose() const override {
    return "show a case with its defaults and what follows from it";
  }
  void declare(CLI::App& app) override {
    app.add_option("CASE", case_, "case file (TOML)")->required();
    app.add_option("--set", overrides_, "override a key of the case, as key=value; may be repeated")
        ->take_all()
        ->allow_extra_args(false);
  }
  exchange::ExitCode run(const std::string&) override {
    const exchange::Case study = exchange::read_case(case_, overrides_);
    fmt::print("{}\n{}", shown(study), derived_figures(study));
    return exchange::ExitCode::success;
  }

private:
  std::string case_;
  std::vector<std::string> overrides_;
};

} // namespace

std::unique_ptr<Command> make_show_command() {
  return std::make_unique<ShowCommand>();
}

} // namespace settle::compare::cli
