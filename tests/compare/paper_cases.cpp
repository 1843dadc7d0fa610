#include "paper_cases.hpp"

namespace settle::compare::test {

exchange::Case paper_case(int layers, exchange::Convention convention, exchange::Law law) {
  exchange::Case study;
  study.title = "The paper's column";
  study.gravity = 9.81;
  study.geometry = {.shape = exchange::Shape::column, .height = 5.0, .width = 0.125, .depth = {}, .dimension = 2};
  study.materials["fill"] = {
      .law = law, .youngs_modulus = 400e3, .poissons_ratio = 0.25, .density = 1720.0, .porosity = {}};
  study.construction = {.layers = layers, .convention = convention, .material = "fill"};
  study.probes["axis"] = {.x = 0.0625, .y = {}, .points_per_layer = 9};
  return study;
}

} // namespace settle::compare::test
