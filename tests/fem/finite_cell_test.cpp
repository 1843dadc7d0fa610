#include <cmath>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <gtest/gtest.h>

#include "finite_strain.hpp"
#include "small_strain.hpp"

namespace settle::fem::testing {
namespace {

using exchange::Law;

constexpr Elasticity constants{.youngs_modulus = 1.0, .poissons_ratio = 0.3};
constexpr std::array all_laws{Law::rate, Law::hencky, Law::neo_hookean};

/// One distorted cell, moved as a test wants.
template <class Parameters>
class DistortedCell : public ::testing::Test {
protected:
  static constexpr int space = Parameters::dim;
  using Field = std::vector<double>;

  DistortedCell()
      : element(dealii::FE_Q<space>(Parameters::degree), space), dofs(mesh),
        values(element, dealii::QGauss<space>(Parameters::degree + 1),
               dealii::update_values | dealii::update_gradients | dealii::update_JxW_values),
        nodes(element, element.get_unit_support_points(), dealii::update_quadrature_points) {
    dealii::GridGenerator::subdivided_hyper_cube(mesh, 3);
    dealii::GridTools::distort_random(0.2, mesh, true, 7);
    dofs.distribute_dofs(element);
    values.reinit(dofs.begin_active());
    nodes.reinit(dofs.begin_active());
    history.displacement = Field(element.n_dofs_per_cell());
    history.stress.resize(values.n_quadrature_points);
  }

  /// Values at the degrees of freedom of the displacement gradient * x.
  [[nodiscard]] Field linear(const dealii::Tensor<2, space>& gradient) const {
    Field field(element.n_dofs_per_cell());
    for (unsigned i = 0; i < field.size(); ++i)
      field[i] = gradient[element.system_to_component_index(i).first] * nodes.quadrature_point(i);
    return field;
  }
  /// Any field, different at all degrees of freedom; the cell is about 1/3 wide.
  [[nodiscard]] Field any(double size, double phase) const {
    Field field(element.n_dofs_per_cell());
    for (unsigned i = 0; i < field.size(); ++i)
      field[i] = size * std::sin(phase + 1.7 * i);
    return field;
  }
  [[nodiscard]] dealii::Vector<double> force(const Formulation<space>& formulation, const Field& increment) const {
    const Trial<space> trial{values, history, increment};
    return formulation.internal_force(trial, formulation.stress(trial).value());
  }
  void accept(const Formulation<space>& formulation, const Field& increment) {
    history.stress = formulation.stress({values, history, increment}).value();
    for (std::size_t i = 0; i < increment.size(); ++i)
      history.displacement[i] += increment[i];
  }
  /// A rotation in the plane of the first and the last axis, minus identity.
  [[nodiscard]] static dealii::Tensor<2, space> turn(double angle) {
    dealii::Tensor<2, space> gradient;
    gradient[0][0] = gradient[space - 1][space - 1] = std::cos(angle) - 1;
    gradient[0][space - 1] = -std::sin(angle);
    gradient[space - 1][0] = std::sin(angle);
    return gradient;
  }

  dealii::Triangulation<space> mesh;
  dealii::FESystem<space> element;
  dealii::DoFHandler<space> dofs;
  dealii::FEValues<space> values, nodes;
  CellHistory<space> history;
};

template <int d, unsigned p>
struct Parameters {
  static constexpr int dim = d;
  static constexpr unsigned degree = p;
};
using Elements = ::testing::Types<Parameters<2, 1>, Parameters<2, 2>, Parameters<3, 1>, Parameters<3, 2>>;
TYPED_TEST_SUITE(DistortedCell, Elements);

TYPED_TEST(DistortedCell, TheTangentIsTheDerivativeOfTheInternalForce) {
  constexpr int dim = TypeParam::dim;
  constexpr double step = 1e-6; // of a cell a third wide
  for (const Law law : all_laws) {
    const FiniteStrain<dim> formulation({{law, constants}});
    this->accept(formulation, this->any(0.01, 0.4));
    const std::vector<double> increment = this->any(0.01, 2.0);
    const auto tangent = formulation.tangent({this->values, this->history, increment});
    for (unsigned j = 0; j < increment.size(); ++j) {
      std::vector<double> forward = increment, backward = increment;
      forward[j] += step;
      backward[j] -= step;
      dealii::Vector<double> difference = this->force(formulation, forward);
      difference -= this->force(formulation, backward);
      difference /= 2 * step;
      for (unsigned i = 0; i < increment.size(); ++i)
        ASSERT_NEAR(difference[i], tangent(i, j), 1e-8 * tangent.linfty_norm()) << exchange::name_of(law) << i << j;
    }
  }
}

TYPED_TEST(DistortedCell, ALargeRigidRotationMeetsNoResistance) {
  constexpr int dim = TypeParam::dim;
  for (const Law law : all_laws) {
    const FiniteStrain<dim> formulation({{law, constants}});
    EXPECT_LT(this->force(formulation, this->linear(this->turn(1.5))).l2_norm(), 1e-13) << exchange::name_of(law);
  }
}

TYPED_TEST(DistortedCell, ARotationTurnsTheForcesOfADeformedCell) {
  constexpr int dim = TypeParam::dim;
  const dealii::Tensor<2, dim> turn = this->turn(1.0);
  for (const Law law : all_laws) {
    const FiniteStrain<dim> formulation({{law, constants}});
    this->history.displacement.assign(this->history.displacement.size(), 0.0);
    this->history.stress.assign(this->history.stress.size(), dealii::SymmetricTensor<2, 3>());
    const std::vector<double> deformed = this->any(0.02, 0.4);
    const dealii::Vector<double> before = this->force(formulation, deformed);
    this->accept(formulation, deformed);
    std::vector<double> rotation = this->linear(turn); // of the position as placed ...
    dealii::Vector<double> expected(before);
    for (unsigned i = 0; i < rotation.size(); ++i) { // ... and of the displacement so far
      const auto [component, node] = this->element.system_to_component_index(i);
      for (unsigned c = 0; c < dim; ++c) {
        const unsigned partner = this->element.component_to_system_index(c, node);
        rotation[i] += turn[component][c] * deformed[partner];
        expected[i] += turn[component][c] * before[partner];
      }
    }
    dealii::Vector<double> after = this->force(formulation, rotation);
    after -= expected;
    EXPECT_LT(after.l2_norm(), 1e-12 * before.l2_norm()) << exchange::name_of(law);
  }
}

TYPED_TEST(DistortedCell, HalfTheHeightGivesUniformStressAndHalfTheVolume) {
  constexpr int dim = TypeParam::dim;
  dealii::Tensor<2, dim> gradient;
  gradient[dim - 1][dim - 1] = -0.25; // twice: to three quarters, then to the half
  const double lame = 0.3 / (1.3 * 0.4), shear = 0.5 / 1.3, e = std::log(0.5);
  const std::array axial{(lame + 2 * shear) * e, (lame + 2 * shear) * e / 0.5, (lame * e + shear * (0.25 - 1)) / 0.5};
  for (std::size_t law = 0; law < 3; ++law) {
    const FiniteStrain<dim> formulation({{all_laws[law], constants}});
    this->history.displacement.assign(this->history.displacement.size(), 0.0);
    this->history.stress.assign(this->history.stress.size(), dealii::SymmetricTensor<2, 3>());
    this->accept(formulation, this->linear(gradient));
    this->accept(formulation, this->linear(gradient));
    for (const auto& stress : this->history.stress)
      EXPECT_NEAR(stress[dim - 1][dim - 1], axial[law], 1e-12 * std::abs(axial[law]));
    for (const Measure& measure : formulation.measures(this->values, this->history)) {
      EXPECT_NEAR(measure.volume_ratio, 0.5, 1e-13);
      EXPECT_NEAR(measure.density_ratio, 2.0, 1e-12);
    }
  }
}

TYPED_TEST(DistortedCell, TinyMotionsMeetTheSmallStrainForceAndTangent) {
  constexpr int dim = TypeParam::dim;
  const SmallStrain<dim> small({constants});
  const std::vector<double> tiny = this->any(1e-9, 0.4);
  const dealii::Vector<double> expected = this->force(small, tiny);
  for (const Law law : all_laws) {
    const FiniteStrain<dim> finite({{law, constants}});
    dealii::Vector<double> force = this->force(finite, tiny);
    force -= expected;
    EXPECT_LT(force.l2_norm(), 1e-7 * expected.l2_norm());
    auto tangent = finite.tangent({this->values, this->history, tiny});
    const double scale = tangent.linfty_norm();
    tangent.add(-1.0, small.tangent({this->values, this->history, tiny}));
    EXPECT_LT(tangent.linfty_norm(), 1e-7 * scale);
  }
}

TYPED_TEST(DistortedCell, ACellTurnedInsideOutHasNoStress) {
  constexpr int dim = TypeParam::dim;
  dealii::Tensor<2, dim> gradient;
  gradient[dim - 1][dim - 1] = -1.5;
  for (const Law law : all_laws)
    EXPECT_FALSE(FiniteStrain<dim>({{law, constants}})
                     .stress({this->values, this->history, this->linear(gradient)})
                     .has_value());
}

} // namespace
} // namespace settle::fem::testing
