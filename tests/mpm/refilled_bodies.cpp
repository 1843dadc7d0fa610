#include "refilled_bodies.hpp"

#include "drawn_box.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::mpm::test {

std::string head_of_refilled(const std::string& law) {
  return "format = 1\ngravity = 10.0\n[material.fill]\nlaw = \"" + law + R"("
youngs_modulus = 120e3
poissons_ratio = 0.25
density = 1720.0
[mpm]
element = "quadrilateral"
element_size = 0.25
[mpm.quasi_static]
increments = 10
[mpm.explicit]
relaxation = "viscous"
damping = 0.9
force_error = 1e-4
energy_error = 1e-4
[construction]
convention = "refill"
material = "fill"
)";
}

exchange::Case refilled_column(const std::string& law, const Overrides& overrides) {
  return exchange::parse_case(head_of_refilled(law) + R"(layers = 4
[geometry]
shape = "column"
dimension = 2
height = 2.0
width = 1.0
)",
                              "column.toml", overrides);
}

exchange::Case refilled_rectangle(const std::string& law, const Overrides& overrides) {
  return exchange::parse_case(head_of_refilled(law) + "layers = 4\n" + polygons_of_box(4, "1.0") +
                                  supports_of_box(4, "1.0"),
                              "polygons.toml", overrides);
}

exchange::Case refilled_embankment(const std::string& stages, const Overrides& overrides) {
  return exchange::parse_case(head_of_refilled("hencky") + R"(layers = 4
[geometry]
shape = "embankment"
dimension = 2
[geometry.embankment]
height = 2.0
crest = 2.0
slopes = [1.5, 1.5]
[probes.axis]
from = [0.0, 0.0]
to = [0.0, 2.0]
points = 9
)" + stages,
                              "embankment.toml", overrides);
}

double volume_of(const exchange::Stage& stage) {
  double sum = 0;
  for (const double volume : stage.points.volume)
    sum += volume;
  return sum;
}

void expect_audited(const std::vector<exchange::Stage>& stages, double balance) {
  double before = 0;
  for (const exchange::Stage& stage : stages) {
    EXPECT_NEAR(before + stage.mass_placed + stage.mass_refilled, stage.mass, 1e-12 * stage.mass);
    EXPECT_NEAR(stage.base_reaction, stage.weight, balance * stage.weight);
    EXPECT_NEAR(stage.weight, 10.0 * stage.mass, 1e-12 * stage.weight);
    before = stage.mass;
  }
}

} // namespace settle::mpm::test
