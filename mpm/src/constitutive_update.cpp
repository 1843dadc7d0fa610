#include "constitutive_update.hpp"

#include <type_traits>
#include <utility>

#include "settle/mpm/hyperelasticity.hpp"

namespace settle::mpm {

namespace {

/// Calls `action` with the type of the body's hyperelastic law; the law `rate` is none and does not come here.
template <class Grid, class Action>
auto with_hyperelastic_law(const Body<Grid>& body, Action&& action) {
  if (body.law == exchange::Law::hencky) return action(std::type_identity<Hencky<Grid::dim>>());
  return action(std::type_identity<NeoHookean<Grid::dim>>());
}

Stress<2> stress_of(const Points<2>& points, std::size_t p) {
  Stress<2> stress;
  stress.tensor << points.stress[0][p], points.stress[3][p], points.stress[3][p], points.stress[1][p];
  stress.out_of_plane = points.stress[2][p];
  return stress;
}

void set_stress(Points<2>& points, std::size_t p, const Stress<2>& stress) {
  points.stress[0][p] = stress.tensor(0, 0);
  points.stress[1][p] = stress.tensor(1, 1);
  points.stress[2][p] = stress.out_of_plane;
  points.stress[3][p] = stress.tensor(0, 1);
}

template <class Grid>
std::pair<std::size_t, std::size_t> points_in(const Body<Grid>& body, int cell) {
  const auto c = static_cast<std::size_t>(cell);
  return {body.cells.begin[c], body.cells.begin[c + 1]};
}

/// Variation of b = F F^T when the displacement of a node with current shape function gradient `g` varies in
/// `direction`.
template <int dim>
Tensor<dim> variation_of_b(const Tensor<dim>& b, const Vector<dim>& g, int direction) {
  Tensor<dim> half = Tensor<dim>::Zero();
  half.row(direction) = g.transpose() * b;
  return half + half.transpose();
}

/// Law `rate`: sigma = R sigma_0 R^T + D : e, e the logarithmic strain of the increment, R its rotation for the Jaumann
/// rate, else the identity. It is linear in sigma_0, so the average of the points' stresses is the stress of their
/// average.
template <class Grid>
CellResponse<Grid> rate_response(const Body<Grid>& body, int cell, const Tensor<Grid::dim>& start,
                                 const IncrementalKinematics<Grid::dim>& kinematics) {
  constexpr int dim = Grid::dim;
  const Tensor<dim> rotation = body.jaumann ? kinematics.rotation() : Tensor<dim>::Identity();
  CellResponse<Grid> response;
  const Tensor<dim> b = kinematics.deformation * kinematics.deformation.transpose();
  const Hencky<dim> increment(body.lame, b);
  response.stress = rotation * start * rotation.transpose() + increment.kirchhoff().tensor;
  for (int dof = 0; dof < dim * Grid::nodes_per_cell; ++dof) {
    const Vector<dim> g = body.grid.gradients(cell).col(dof / dim);
    const Vector<dim> current = kinematics.inverse.transpose() * g;
    Tensor<dim> variation = increment.variation(variation_of_b<dim>(b, current, dof % dim)).tensor;
    if (body.jaumann) {
      const Tensor<dim> d_rotation = 0.5 * kinematics.half_rotation() * kinematics.spin_variation(g, dof % dim) *
                                     (Tensor<dim>::Identity() + rotation);
      const Tensor<dim> turned = d_rotation * start * rotation.transpose();
      variation += turned + turned.transpose();
    }
    response.variations[static_cast<std::size_t>(dof)] = variation;
  }
  return response;
}

/// sigma = tau(b) / J point by point; d_sigma = d_tau / J - div(d_u) sigma.
template <class Law, class Grid>
CellResponse<Grid> hyperelastic_response(const Body<Grid>& body, int cell, double points_volume,
                                         const IncrementalKinematics<Grid::dim>& kinematics) {
  constexpr int dim = Grid::dim;
  const typename Grid::Gradients gradients = kinematics.inverse.transpose() * body.grid.gradients(cell);
  const Tensor<dim> increment = kinematics.deformation;
  CellResponse<Grid> response;
  response.stress.setZero();
  response.variations.fill(Tensor<dim>::Zero());
  const auto [first, last] = points_in(body, cell);
  for (std::size_t p = first; p < last; ++p) {
    const double weight = body.points.volume[p] / points_volume;
    const Tensor<dim> deformation = increment * body.points.deformation_of(p);
    const Tensor<dim> b = deformation * deformation.transpose();
    const double jacobian = deformation.determinant();
    const Law law(body.lame, b);
    const Tensor<dim> sigma = law.kirchhoff().tensor / jacobian;
    response.stress += weight * sigma;
    for (int dof = 0; dof < dim * Grid::nodes_per_cell; ++dof) {
      const Vector<dim> g = gradients.col(dof / dim);
      const Tensor<dim> d_tau = law.variation(variation_of_b<dim>(b, g, dof % dim)).tensor;
      response.variations[static_cast<std::size_t>(dof)] += weight * (d_tau / jacobian - g[dof % dim] * sigma);
    }
  }
  return response;
}

template <class Grid>
void deform_rate_points(Body<Grid>& body, int cell, const IncrementalKinematics<Grid::dim>& kinematics,
                        StrainMeasure measure) {
  constexpr int dim = Grid::dim;
  const auto increment =
      measure == StrainMeasure::midpoint
          ? stress_increment<dim>(body.lame, kinematics.strain)
          : Hencky<dim>(body.lame, kinematics.deformation * kinematics.deformation.transpose()).kirchhoff();
  const auto [first, last] = points_in(body, cell);
  for (std::size_t p = first; p < last; ++p) {
    auto stress = stress_of(body.points, p);
    if (body.jaumann) {
      const Tensor<dim> rotation = kinematics.rotation();
      stress.tensor = (rotation * stress.tensor * rotation.transpose()).eval();
    }
    stress.tensor += increment.tensor;
    stress.out_of_plane += increment.out_of_plane;
    set_stress(body.points, p, stress);
  }
}

template <class Law, class Grid>
void deform_hyperelastic_points(Body<Grid>& body, int cell, const IncrementalKinematics<Grid::dim>& kinematics) {
  constexpr int dim = Grid::dim;
  const Tensor<dim> increment = kinematics.deformation;
  const auto [first, last] = points_in(body, cell);
  for (std::size_t p = first; p < last; ++p) {
    const Tensor<dim> deformation = increment * body.points.deformation_of(p);
    body.points.set_deformation(p, deformation);
    Stress<dim> stress = Law(body.lame, deformation * deformation.transpose()).kirchhoff();
    stress.tensor /= deformation.determinant();
    stress.out_of_plane /= deformation.determinant();
    set_stress(body.points, p, stress);
  }
}

} // namespace

template <class Grid>
CellResponse<Grid> respond(const Body<Grid>& body, int cell, const CellStress<Grid::dim>& start,
                           const IncrementalKinematics<Grid::dim>& kinematics) {
  if (body.law == exchange::Law::rate) return rate_response(body, cell, start.average.tensor, kinematics);
  return with_hyperelastic_law(body, [&]<class Law>(std::type_identity<Law>) {
    return hyperelastic_response<Law>(body, cell, start.points_volume, kinematics);
  });
}

template <class Grid>
void deform_points(Body<Grid>& body, int cell, const IncrementalKinematics<Grid::dim>& kinematics,
                   StrainMeasure measure) {
  const auto [first, last] = points_in(body, cell);
  for (std::size_t p = first; p < last; ++p)
    body.points.volume[p] *= kinematics.volume_ratio;
  if (body.law == exchange::Law::rate) return deform_rate_points(body, cell, kinematics, measure);
  with_hyperelastic_law(
      body, [&]<class Law>(std::type_identity<Law>) { deform_hyperelastic_points<Law>(body, cell, kinematics); });
}

template CellResponse<TriangleGrid> respond(const Body<TriangleGrid>&, int, const CellStress<2>&,
                                            const IncrementalKinematics<2>&);
template void deform_points(Body<TriangleGrid>&, int, const IncrementalKinematics<2>&, StrainMeasure);

} // namespace settle::mpm
