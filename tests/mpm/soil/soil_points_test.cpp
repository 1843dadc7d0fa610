// Points of soils in a body: their response, their update, the increment that balances them.
#include <cmath>

#include <gmock/gmock.h>

#include "blocks.hpp"
#include "constitutive_update.hpp"
#include "settle/mpm/quasi_static_step.hpp"

namespace settle::mpm::test {
namespace {

struct Model {
  std::string name;
  soil::Soil law;
  exchange::Law kind;
  bool jaumann = false;
};

std::ostream& operator<<(std::ostream& out, const Model& model) {
  return out << model.name;
}

const Lame lame = Lame::from(20e6, 0.3);

std::vector<Model> models() {
  std::vector<Model> all{
      {"tresca", soil::Tresca{.lame = lame, .cohesion = 30e3}, exchange::Law::tresca},
      {"mohr_coulomb", soil::MohrCoulomb{.lame = lame, .cohesion = 20e3, .friction_angle = 0.5, .dilation_angle = 0.1},
       exchange::Law::mohr_coulomb},
      {"drucker_prager",
       soil::DruckerPrager{.lame = lame, .cohesion = 20e3, .friction_angle = 0.5, .dilation_angle = 0.1},
       exchange::Law::drucker_prager},
      {"cam_clay",
       soil::CamClay{.shear_modulus = 4e6,
                     .critical_state_slope = 1.2,
                     .compression_index = 0.2,
                     .swelling_index = 0.04,
                     .void_ratio = 1.0,
                     .preconsolidation_pressure = 60e3,
                     .attraction = 30e3},
       exchange::Law::cam_clay},
      {"stress_dependent", soil::StressDependent{.lame = lame, .stiffness_exponent = 0.5, .reference_pressure = 50e3},
       exchange::Law::stress_dependent},
      {"rate_in_layers", soil::Elastic{lame}, exchange::Law::rate}};
  const auto n = all.size();
  for (std::size_t i = 0; i < n; ++i)
    all.push_back({all[i].name + "_jaumann", all[i].law, all[i].kind, true});
  return all;
}

/// A body of squares, all layers of the model.
template <class Space>
Body<Space> body_of(const Model& model, const Block& data) {
  Body<Space> body = block<Space>(data);
  const double height = data.filled_rows * data.size;
  body.points = {};
  body.points.has_domains = Space::has_domains;
  body.points.yields = body.points.hardens = true;
  body.materials = {{.law = model.kind, .lame = lame, .density = block_density, .soil = model.law}};
  body.jaumann = model.jaumann;
  place_layer(body, {.layer = 1, .base = 0.0, .thickness = height});
  body.sort();
  return body;
}

Tensor<2> tensor(double xx, double xy, double yx, double yy) {
  Tensor<2> t;
  t << xx, xy, yx, yy;
  return t;
}

class EverySoilInABody : public testing::TestWithParam<Model> {
protected:
  /// One square, its points deformed so that they yield.
  EverySoilInABody()
      : body(body_of<TriangleSpace>(GetParam(), {.columns = 1, .rows = 1, .filled_rows = 1, .supported = false})) {
    const IncrementalKinematics<2> start(tensor(-0.002, 0.003, 0.001, -0.006));
    deform_points(body, points_in(body, 0), start, StrainMeasure::logarithmic);
  }
  Body<TriangleSpace> body;
  Tensor<2> gradient = tensor(0.002, -0.004, 0.003, -0.005);
};
INSTANTIATE_TEST_SUITE_P(Laws, EverySoilInABody, testing::ValuesIn(models()),
                         [](const auto& tested) { return tested.param.name; });

TEST_P(EverySoilInABody, TheResponseIsTheStressThatThePointsGet) {
  const auto range = points_in(body, 0);
  const auto start = average_stress_of(body.points, range);
  const IncrementalKinematics<2> kinematics(gradient);
  const auto response = respond(body, range, start, kinematics);
  deform_points(body, range, kinematics, StrainMeasure::logarithmic);
  const Tensor<2> after = average_stress_of(body.points, range).average.tensor;
  EXPECT_LT((response.stress - after).norm(), 1e-12 * after.norm());
}

TEST_P(EverySoilInABody, VariationsAreTheDerivativesOfTheResponse) {
  const auto range = points_in(body, 0);
  const auto start = average_stress_of(body.points, range);
  const auto response = respond(body, range, start, IncrementalKinematics<2>(gradient));
  const double step = 1e-7;
  const Tensor<2> deformation = Tensor<2>::Identity() + gradient;
  for (int b = 0; b < 2; ++b)
    for (int a = 0; a < 2; ++a) {
      const Tensor<2> direction = Vector<2>::Unit(b) * Vector<2>::Unit(a).transpose() * deformation;
      const auto stress_at = [&](double s) {
        return respond(body, range, start, IncrementalKinematics<2>(gradient + s * direction)).stress;
      };
      const Tensor<2> difference = (stress_at(step) - stress_at(-step)) / (2.0 * step);
      const Tensor<2>& variation = response.by_gradient[static_cast<std::size_t>(b)][static_cast<std::size_t>(a)];
      EXPECT_LT((variation - difference).norm(), 1e-6 * lame.mu) << "component " << b << a;
    }
}

/// The Newton iteration is only as good as its tangent; without yielding it has no kinks to cross.
template <class Space>
class MeanVolume : public testing::Test {};
using PlaneAndSolid = testing::Types<QuadrilateralSpace, GimpSpace<2>, BSplineSpace<2>, HexahedronSpace>;
TYPED_TEST_SUITE(MeanVolume, PlaneAndSolid, SpaceName);

TYPED_TEST(MeanVolume, NewtonConvergesQuadratically) {
  std::mt19937 random(3);
  auto body = body_of<TypeParam>({"elastic", soil::Elastic{lame}, exchange::Law::rate}, {.rows = 5, .filled_rows = 4});
  body.mean_volume = true;
  scatter_positions(body, random, 0.05);
  const auto report = QuasiStaticStep<TypeParam>(1e-10).advance(body, {.acceleration = 2000.0});
  ASSERT_TRUE(report.converged);
  const auto& residuals = report.residuals;
  int judged = 0;
  for (std::size_t k = 1; k + 1 < residuals.size(); ++k) {
    if (residuals[k] > 0.2 || residuals[k + 1] < 1e-13) continue;
    EXPECT_GT(std::log(residuals[k + 1] / residuals[k]) / std::log(residuals[k] / residuals[k - 1]), 1.7) << k;
    ++judged;
  }
  EXPECT_GE(judged, 2) << testing::PrintToString(residuals);
}

TYPED_TEST(MeanVolume, ChangesNothingWhereACellDeformsAlike) {
  const auto settled = [](bool mean_volume) {
    auto body = body_of<TypeParam>({"elastic", soil::Elastic{lame}, exchange::Law::rate},
                                   {.columns = 1, .deep = 1, .rows = 5, .filled_rows = 4});
    body.mean_volume = mean_volume;
    EXPECT_TRUE(QuasiStaticStep<TypeParam>(1e-12).advance(body, {.acceleration = 20.0}).converged);
    return body.points.position;
  };
  const auto with = settled(true), without = settled(false);
  double moved = 0;
  for (std::size_t d = 0; d < with.size(); ++d)
    for (std::size_t p = 0; p < with[d].size(); ++p)
      moved = std::max(moved, std::abs(with[d][p] - without[d][p]));
  // Of 2 m that settle by 3 mm: mean strains of cells, not those of points, which differ within a cell for B-splines.
  const bool uniform_in_cells = !std::is_same_v<TypeParam, BSplineSpace<2>>;
  EXPECT_LT(moved, uniform_in_cells ? 1e-5 : 1e-4);
}

} // namespace
} // namespace settle::mpm::test
