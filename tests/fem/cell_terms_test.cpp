#include "cell_terms.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <gtest/gtest.h>

#include "elasticity.hpp"

namespace settle::fem::testing {
namespace {

constexpr Elasticity law{.youngs_modulus = 1.0, .poissons_ratio = 0.3};
constexpr double round_off = 1e-13;

/// u = shift + gradient x.
template <int dim>
struct LinearField {
  dealii::Tensor<1, dim> shift;
  dealii::Tensor<2, dim> gradient;
};

/// A general gradient: every component different.
template <int dim>
LinearField<dim> general_field() {
  LinearField<dim> field;
  for (unsigned i = 0; i < dim; ++i) {
    field.shift[i] = 0.3 - 0.1 * i;
    for (unsigned j = 0; j < dim; ++j)
      field.gradient[i][j] = 0.02 * (i + 1.0) - 0.05 * j * (i + 0.5);
  }
  return field;
}

/// Cells of a randomly distorted mesh, one after another, with FEValues ready.
template <class Parameters>
class DistortedMesh : public ::testing::Test {
protected:
  static constexpr int space = Parameters::dim;

  DistortedMesh()
      : element(dealii::FE_Q<space>(Parameters::degree), space), dofs(mesh),
        values(element, dealii::QGauss<space>(Parameters::degree + 1),
               dealii::update_values | dealii::update_gradients | dealii::update_JxW_values),
        nodes(element, element.get_unit_support_points(), dealii::update_quadrature_points) {
    dealii::GridGenerator::subdivided_hyper_cube(mesh, 3);
    dealii::GridTools::distort_random(0.2, mesh, true, 7);
    dofs.distribute_dofs(element);
  }

  /// Values of a linear field at the degrees of freedom of the cell `nodes` stands on.
  std::vector<double> at_dofs(const LinearField<space>& field) const {
    std::vector<double> result(element.n_dofs_per_cell());
    for (unsigned i = 0; i < result.size(); ++i) {
      const unsigned c = element.system_to_component_index(i).first;
      result[i] = field.shift[c] + field.gradient[c] * nodes.quadrature_point(i);
    }
    return result;
  }

  template <class Body>
  void for_each_cell(const Body& body) {
    for (const auto& cell : dofs.active_cell_iterators()) {
      values.reinit(cell);
      nodes.reinit(cell);
      body(cell);
    }
  }

  dealii::Triangulation<space> mesh;
  dealii::FESystem<space> element;
  dealii::DoFHandler<space> dofs;
  dealii::FEValues<space> values;
  dealii::FEValues<space> nodes;
};

template <int d, unsigned p>
struct Parameters {
  static constexpr int dim = d;
  static constexpr unsigned degree = p;
};
using Elements = ::testing::Types<Parameters<2, 1>, Parameters<2, 2>, Parameters<3, 1>, Parameters<3, 2>>;
TYPED_TEST_SUITE(DistortedMesh, Elements);

TYPED_TEST(DistortedMesh, ALinearFieldHasUniformStrain) {
  constexpr int dim = TypeParam::dim;
  const LinearField<dim> field = general_field<dim>();
  const dealii::SymmetricTensor<2, dim> expected = symmetrize(field.gradient);
  this->for_each_cell([&](const auto&) {
    for (const auto& strain : strains(this->values, this->at_dofs(field)))
      EXPECT_LT((strain - expected).norm(), round_off);
  });
}

TYPED_TEST(DistortedMesh, ARigidMotionMeetsNoResistance) {
  constexpr int dim = TypeParam::dim;
  LinearField<dim> motion = general_field<dim>();
  motion.gradient -= transpose(motion.gradient); // an infinitesimal rotation
  ASSERT_GT(motion.gradient.norm(), 0.01);
  this->for_each_cell([&](const auto&) {
    const std::vector<double> moved = this->at_dofs(motion);
    const dealii::Vector<double> displacement(moved.begin(), moved.end());
    dealii::Vector<double> force(displacement.size());
    stiffness_matrix(this->values, stiffness<dim>(law)).vmult(force, displacement);
    EXPECT_LT(force.l2_norm(), round_off);
  });
}

TYPED_TEST(DistortedMesh, UniformStressIsInEquilibriumAtEveryInnerNode) {
  constexpr int dim = TypeParam::dim;
  const dealii::SymmetricTensor<2, dim> stress = stiffness<dim>(law) * symmetrize(general_field<dim>().gradient);
  const std::vector<dealii::SymmetricTensor<2, dim>> everywhere(this->values.n_quadrature_points, stress);
  dealii::Vector<double> force(this->dofs.n_dofs());
  std::vector<bool> on_boundary(this->dofs.n_dofs(), false);
  std::vector<dealii::types::global_dof_index> indices(this->element.n_dofs_per_cell());
  this->for_each_cell([&](const auto& cell) {
    cell->get_dof_indices(indices);
    force.add(indices, internal_force(this->values, everywhere));
    for (unsigned i = 0; i < indices.size(); ++i)
      for (unsigned c = 0; c < dim; ++c) {
        const double x = this->nodes.quadrature_point(i)[c];
        if (x < 1e-9 || x > 1 - 1e-9) on_boundary[indices[i]] = true; // of the unit cube
      }
  });
  double boundary_norm = 0.0;
  for (unsigned i = 0; i < force.size(); ++i) {
    if (on_boundary[i])
      boundary_norm += force[i] * force[i];
    else
      EXPECT_NEAR(force[i], 0.0, round_off);
  }
  EXPECT_GT(boundary_norm, 1e-6);
}

TYPED_TEST(DistortedMesh, StiffnessTimesDisplacementIsTheForceOfItsStress) {
  constexpr int dim = TypeParam::dim;
  const auto tangent = stiffness<dim>(law);
  this->for_each_cell([&](const auto&) {
    std::vector<double> values_at_dofs(this->element.n_dofs_per_cell());
    for (unsigned i = 0; i < values_at_dofs.size(); ++i)
      values_at_dofs[i] = 0.01 * ((7 * i) % 5 - 2.0); // any field
    auto stress = strains(this->values, values_at_dofs);
    for (auto& tensor : stress)
      tensor = tangent * tensor;
    dealii::Vector<double> difference(this->element.n_dofs_per_cell());
    stiffness_matrix(this->values, tangent)
        .vmult(difference, dealii::Vector<double>(values_at_dofs.begin(), values_at_dofs.end()));
    difference -= internal_force(this->values, stress);
    EXPECT_LT(difference.l2_norm(), round_off);
  });
}

TYPED_TEST(DistortedMesh, BodyForcesAddUpToForceTimesVolume) {
  constexpr int dim = TypeParam::dim;
  dealii::Tensor<1, dim> per_volume;
  per_volume[dim - 1] = -3.0;
  double total = 0.0;
  this->for_each_cell([&](const auto&) {
    const dealii::Vector<double> force =
        body_force(this->values, std::vector(this->values.n_quadrature_points, per_volume));
    for (unsigned i = 0; i < force.size(); ++i)
      total += this->element.system_to_component_index(i).first == dim - 1 ? force[i] : std::abs(force[i]);
  });
  EXPECT_NEAR(total, -3.0, 1e-12); // the cube's volume is 1
}

} // namespace
} // namespace settle::fem::testing
