#include "settle/mpm/solver.hpp"

#include <type_traits>

#include "builder.hpp"
#include "settle/mpm/point_path.hpp"
#include "settle/mpm/requirements.hpp"
#include "settle/mpm/spaces.hpp"

namespace settle::mpm {

namespace {

/// Calls `action` with the type of the space of squares or cubes that has this basis, std::type_identity<Space>.
template <int dim, class Action>
auto with_box_space(exchange::Basis basis, Action&& action) {
  switch (basis) {
  case exchange::Basis::linear:
    break;
  case exchange::Basis::gimp:
    return action(std::type_identity<GimpSpace<dim>>());
  case exchange::Basis::b_spline:
    return action(std::type_identity<BSplineSpace<dim>>());
  case exchange::Basis::b_spline_gimp:
    return action(std::type_identity<BSplineGimpSpace<dim>>());
  }
  return action(std::type_identity<BoxSpace<dim>>());
}

/// The same with the case's space.
template <class Action>
auto with_space(const exchange::Case& study, Action&& action) {
  switch (study.mpm.element) {
  case exchange::MpmElement::triangle:
    return action(std::type_identity<TriangleSpace>());
  case exchange::MpmElement::tetrahedron:
    return action(std::type_identity<TetrahedronSpace>());
  case exchange::MpmElement::hexahedron:
    return with_box_space<3>(study.mpm.basis, action);
  case exchange::MpmElement::quadrilateral:
    break;
  }
  return with_box_space<2>(study.mpm.basis, action);
}

} // namespace

exchange::Used used(const exchange::Case& study) {
  const Material fill = material_of(study.fill());
  exchange::Used values = exchange::used_values(study, exchange::Kinematics::finite);
  values.youngs_modulus = fill.lame.youngs_modulus();
  values.poissons_ratio = fill.lame.poissons_ratio();
  values.density = fill.density;
  values.law = fill.law;
  return values;
}

int threads(const exchange::Case& study) {
  return study.geometry.shape == exchange::Shape::point ? 1 : study.mpm.threads;
}

std::optional<exchange::Failure> solve(const exchange::Case& study, const exchange::StageSink& sink) {
  require_solvable(study);
  if (study.geometry.shape == exchange::Shape::point) {
    drive_points(study, sink);
    return {};
  }
  return with_space(study, [&]<class Space>(std::type_identity<Space>) -> std::optional<exchange::Failure> {
    Builder<Space> builder(study);
    for (int number = 1; number <= study.n_stages(); ++number) {
      const auto built = builder.build(number);
      if (!built.failed_at || *built.failed_at > 0.0) sink(built.stage);
      if (!built.failed_at) continue;
      exchange::Failure failure{.stage = number, .share = *built.failed_at};
      if (builder.runs_out()) failure.run_out = builder.run_out(number);
      return failure;
    }
    return {};
  });
}

} // namespace settle::mpm
