#include "stage_keys.hpp"

namespace settle::exchange {
namespace {

constexpr std::size_t plane = 2, space = 3;

} // namespace

KeyTable<StageEntry> stage_keys() {
  KeyTable<StageEntry> keys("A step of the construction; without any, one for each layer, in their order.");
  const Count vector{.least = plane, .most = space};
  keys.choice("action", &StageEntry::action,
              {.doc = "existing ground comes to rest and its displacements are set to zero; a layer is placed, or "
                      "removed; nothing changes; or the surface is loaded"});
  keys.integer("layer", &StageEntry::layer, {.range = at_least(1), .doc = "of ground, place and remove: the layer"});
  keys.real("k0", &StageEntry::k0,
            {.range = at_least(0),
             .left_out = "as its law has it",
             .doc = "of ground: horizontal over vertical stress at the start, level ground only"});
  keys.reals("from", &StageEntry::from,
             {.unit = "m",
              .count = vector,
              .left_out = "required for load",
              .doc = "`[x, y]` of one end of a straight part of the surface; the body lies to the left of the way to "
                     "the other. Of a mesh in space `[x, y, z]`, a corner of an upright box, which may be flat: the "
                     "sides of cells in it that are free"});
  keys.reals("to", &StageEntry::to,
             {.unit = "m",
              .count = vector,
              .left_out = "required for load",
              .doc = "`[x, y]` of the other end; `[x, y, z]` of the opposite corner"});
  keys.reals("traction", &StageEntry::traction,
             {.unit = "Pa",
              .count = vector,
              .left_out = "required for load",
              .doc = "`[x, y]`, of a mesh in space `[x, y, z]`: force per area, raised over the stage and kept"});
  return keys;
}

KeyTable<PathLeg> path_keys() {
  KeyTable<PathLeg> keys(
      "A leg of the way of a single material point, with the shape \"point\" only. Legs of a point follow one another, "
      "one a stage; all points have as many.");
  const Count tensor{.least = 6, .most = 6};
  keys.integer("point", &PathLeg::point, {.range = at_least(1), .doc = "whose leg it is, numbered from 1"});
  keys.texts("control", &PathLeg::control,
             {.count = tensor,
              .left_out = "all strain",
              .doc = "`\"strain\"` or `\"stress\"` for xx, yy, zz, xy, yz, xz: what is given of a component"});
  keys.reals("increment", &PathLeg::increment,
             {.count = tensor,
              .required = true,
              .doc = "over the leg, of the tensor of strain or of stress [Pa]: xx, yy, zz, xy, yz, xz"});
  keys.integer("increments", &PathLeg::increments, {.range = at_least(1), .doc = "equal steps of the leg"});
  return keys;
}

KeyTable<InitialState> initial_keys() {
  KeyTable<InitialState> keys("State of single material points at the start, with the shape \"point\" only.");
  keys.reals("stress", &InitialState::stress,
             {.unit = "Pa",
              .count = {.least = 6, .most = 6},
              .left_out = "zero",
              .doc = "Cauchy stress: xx, yy, zz, xy, yz, xz"});
  return keys;
}

} // namespace settle::exchange
