#include "stage_consistency.hpp"

#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "embankment.hpp"
#include "mesh_body.hpp"
#include "settle/exchange/loaded_surface.hpp"
#include "settle/exchange/mesh_geometry.hpp"

namespace settle::exchange {
namespace {

bool names_a_layer(Action action) {
  return action == Action::ground || action == Action::place || action == Action::remove;
}

bool fills_a_box(const Mesh& mesh, int layer) {
  constexpr double round_off = 1e-9; // of its volume
  const SolidBox box = LayerOfMesh(mesh, layer).box();
  double volume = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    volume *= box.highest[axis] - box.lowest[axis];
  return std::abs(layer_volume(mesh, layer) - volume) <= round_off * volume;
}

/// The layers as the stages before have left them.
class Course {
public:
  Course(const Case& study, Reading& reading) : study_(study), reading_(reading) {}

  void follow(std::size_t number) {
    const StageEntry& entry = study_.stages[number];
    key_ = fmt::format("stage.{}", number);
    if (names_a_layer(entry.action) && entry.layer > study_.construction.layers)
      return refuse(".layer", " is not a layer of the case", fmt::format("layer {}", entry.layer),
                    fmt::format("from 1 to {} (construction.layers)", study_.construction.layers));
    switch (entry.action) {
    case Action::ground:
      if (above_ground_) refuse(".action", " is existing ground after other stages", "ground", "ground stages first");
      [[fallthrough]];
    case Action::place:
      above_ground_ = above_ground_ || entry.action == Action::place;
      if (!ever_.insert(entry.layer).second)
        refuse(".layer", " is placed a second time", fmt::format("layer {}", entry.layer), "each layer once");
      present_.insert(entry.layer);
      break;
    case Action::remove:
      above_ground_ = true;
      if (present_.erase(entry.layer) == 0)
        refuse(".layer", " is removed but not there", fmt::format("layer {}", entry.layer), "a layer that is placed");
      if (present_.empty())
        refuse(".layer", " leaves nothing", fmt::format("layer {}", entry.layer), "layers that stay");
      break;
    case Action::hold:
    case Action::load:
      above_ground_ = true;
      if (present_.empty()) refuse(".action", " comes before any layer", std::string(name_of(entry.action)), "place");
      break;
    }
    check_load(entry);
    check_k0(entry);
  }

  void require_all_placed() const {
    for (int layer = 1; layer <= study_.construction.layers; ++layer)
      if (!ever_.contains(layer))
        reading_.complain({.where = study_.where("stage"),
                           .what = fmt::format("layer {} is never placed", layer),
                           .given = fmt::format("{} stages", study_.stages.size()),
                           .allowed = "a stage of action ground or place for every layer",
                           .remedy = "add it, or lower construction.layers"});
  }

private:
  void refuse(const std::string& last, const std::string& what, const std::string& given, const std::string& allowed) {
    reading_.complain({.where = study_.where(key_ + last),
                       .what = key_ + last + what,
                       .given = given,
                       .allowed = allowed,
                       .remedy = {}});
  }

  void check_load(const StageEntry& entry) {
    const bool whole = !entry.from.empty() && !entry.to.empty() && !entry.traction.empty();
    const bool some = !entry.from.empty() || !entry.to.empty() || !entry.traction.empty();
    if (entry.action == Action::load && !whole)
      return refuse("", " does not say what is loaded", "action = \"load\"",
                    fmt::format("from, to and traction, each {}", coordinates()));
    if (entry.action != Action::load && some)
      return refuse("", " gives a load that it does not apply", fmt::format("action = \"{}\"", name_of(entry.action)),
                    "from, to and traction with action = \"load\" only");
    if (!whole) return;
    const std::size_t expected = study_.geometry.solid_mesh() ? 3 : 2;
    for (const auto& [key, vector] :
         {std::pair(".from", &entry.from), {".to", &entry.to}, {".traction", &entry.traction}})
      if (vector->size() != expected)
        return refuse(key, " has another number of coordinates than what is loaded",
                      fmt::format("[{}]", fmt::join(*vector, ", ")), coordinates());
    if (entry.from == entry.to)
      return refuse(".to", " loads a line without length", fmt::format("({}) twice", fmt::join(entry.to, ", ")),
                    "two different ends");
    if (study_.geometry.solid_mesh()) check_loaded_sides(entry);
  }

  [[nodiscard]] const char* coordinates() const {
    return study_.geometry.solid_mesh() ? "[x, y, z]" : "[x, y], of the section";
  }

  void check_loaded_sides(const StageEntry& entry) {
    const SidesInBox sides = sides_in_box(*study_.geometry.mesh, entry, present_);
    const std::string box = fmt::format("from ({}) to ({})", fmt::join(entry.from, ", "), fmt::join(entry.to, ", "));
    if (sides.whole.empty())
      refuse(".from", " loads no side of the mesh: none lies between the ends, free, and on the body as it is then",
             box, "opposite corners of an upright box, which may be flat");
    if (!sides.cut.empty())
      refuse(".from", fmt::format(" cuts sides of the mesh: {} of them lie in the box in part", sides.cut.size()), box,
             "ends between which sides of cells lie as a whole");
  }

  void check_k0(const StageEntry& entry) {
    if (!entry.k0) return;
    if (entry.action != Action::ground)
      refuse(".k0", " is for existing ground only", fmt::format("action = \"{}\"", name_of(entry.action)),
             "action = \"ground\"");
    const Geometry& geometry = study_.geometry;
    const bool between_slopes = geometry.valley || (geometry.solid_mesh() && !fills_a_box(*geometry.mesh, entry.layer));
    if (between_slopes)
      refuse(".k0", " is for level ground between upright sides",
             geometry.valley ? "a layer between the flanks of a valley" : "a layer of a mesh that fills no upright box",
             "no k0: the ground comes to rest under its weight");
  }

  const Case& study_;
  Reading& reading_;
  std::string key_;
  std::set<int> ever_, present_;
  bool above_ground_ = false;
};

int existing_layers(const Geometry& geometry) {
  return geometry.mesh ? ground_layers(*geometry.mesh) : ground_layers(geometry);
}

bool are_plain(const std::vector<StageEntry>& stages) {
  int layer = 0;
  for (const StageEntry& entry : stages)
    if (entry.action != Action::place || entry.layer != ++layer) return false;
  return true;
}

} // namespace

void fill_stages(Case& study) {
  if (study.geometry.shape == Shape::point) return;
  if (study.stages.empty())
    for (int layer = 1; layer <= study.construction.layers; ++layer)
      study.stages.push_back(
          {.action = layer <= existing_layers(study.geometry) ? Action::ground : Action::place, .layer = layer});
  int placed = 1;
  for (StageEntry& entry : study.stages) {
    if (entry.action == Action::ground || entry.action == Action::place) placed = entry.layer;
    if (!names_a_layer(entry.action)) entry.layer = placed;
  }
}

void check_stages(const Case& study, Reading& reading) {
  if (!study.geometry.drawn() && !are_plain(study.stages)) {
    reading.complain({.where = study.where("stage"),
                      .what = "a column is built layer by layer, and nothing else happens to it",
                      .given = fmt::format("{} stages", study.stages.size()),
                      .allowed = "no [[stage]]",
                      .remedy = "leave them out, or draw the body (geometry.shape = \"polygons\")"});
    return;
  }
  Course course(study, reading);
  for (std::size_t number = 0; number < study.stages.size(); ++number)
    course.follow(number);
  course.require_all_placed();
}

} // namespace settle::exchange
