#include "material_consistency.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace settle::exchange {
namespace {

/// A key that belongs to some laws.
struct LawKey {
  const char* name;
  std::optional<double> Material::*value;
  std::vector<Law> needed; ///< by these
  std::vector<Law> taken;  ///< by these too, if given
};

const std::vector<LawKey>& law_keys() {
  using enum Law;
  static const std::vector<LawKey> keys{
      {"cohesion", &Material::cohesion, {tresca, mohr_coulomb, drucker_prager}, {}},
      {"friction_angle", &Material::friction_angle, {mohr_coulomb, drucker_prager}, {}},
      {"dilation_angle", &Material::dilation_angle, {}, {mohr_coulomb, drucker_prager}},
      {"tensile_strength", &Material::tensile_strength, {}, {mohr_coulomb, drucker_prager}},
      {"critical_state_slope", &Material::critical_state_slope, {cam_clay}, {}},
      {"compression_index", &Material::compression_index, {cam_clay}, {}},
      {"swelling_index", &Material::swelling_index, {cam_clay}, {}},
      {"void_ratio", &Material::void_ratio, {cam_clay}, {}},
      {"preconsolidation_pressure", &Material::preconsolidation_pressure, {cam_clay}, {}},
      {"attraction", &Material::attraction, {}, {cam_clay}},
      {"stiffness_exponent", &Material::stiffness_exponent, {stress_dependent}, {}},
      {"reference_pressure", &Material::reference_pressure, {stress_dependent}, {}}};
  return keys;
}

bool holds(const std::vector<Law>& laws, Law law) {
  return std::find(laws.begin(), laws.end(), law) != laws.end();
}

std::string names_of(const LawKey& key) {
  std::vector<std::string> names;
  for (const std::vector<Law>& laws : {key.needed, key.taken})
    for (const Law law : laws)
      names.push_back(fmt::format("\"{}\"", name_of(law)));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// A material while it is checked.
struct Checked {
  const Case& study;
  const std::string& name;
  const Material& material;
  Reading& reading;

  [[nodiscard]] std::string key(const char* last) const { return fmt::format("material.{}.{}", name, last); }
  [[nodiscard]] std::string law() const { return fmt::format("law = \"{}\"", name_of(material.law)); }
};

void check_key(const Checked& checked, const LawKey& key) {
  const bool given = (checked.material.*key.value).has_value();
  if (!given && holds(key.needed, checked.material.law))
    checked.reading.complain({.where = checked.study.where("material." + checked.name),
                              .what = checked.key(key.name) + " is missing",
                              .given = checked.law(),
                              .allowed = "a number, see docs/formats.md",
                              .remedy = fmt::format("the law needs {}", key.name)});
  if (given && !holds(key.needed, checked.material.law) && !holds(key.taken, checked.material.law))
    checked.reading.complain({.where = checked.study.where(checked.key(key.name)),
                              .what = checked.key(key.name) + " means nothing to this law",
                              .given = checked.law(),
                              .allowed = fmt::format("it belongs to {}", names_of(key)),
                              .remedy = "leave it out, or take another law"});
}

void refuse(const Checked& checked, const char* key, double given, const std::string& what,
            const std::string& allowed) {
  checked.reading.complain({.where = checked.study.where(checked.key(key)),
                            .what = checked.key(key) + what,
                            .given = fmt::format("{}", given),
                            .allowed = allowed,
                            .remedy = {}});
}

/// Values that do not go together.
void check_values(const Checked& checked) {
  const Material& material = checked.material;
  if (material.law == Law::tresca && material.cohesion == 0.0)
    refuse(checked, "cohesion", 0.0, " is the only strength of tresca", "a number above 0 [Pa]");
  if (material.friction_angle && material.dilation_angle.value_or(0) > *material.friction_angle)
    refuse(checked, "dilation_angle", *material.dilation_angle, " is above the angle of friction",
           fmt::format("from 0 to {} [degrees]", *material.friction_angle));
  if (material.friction_angle == 0.0 && material.cohesion == 0.0)
    refuse(checked, "cohesion", 0.0, " is zero, and so is the angle of friction", "some strength");
  if (material.compression_index && material.swelling_index && *material.swelling_index >= *material.compression_index)
    refuse(checked, "swelling_index", *material.swelling_index, " is not below the compression index",
           fmt::format("above 0, below {}", *material.compression_index));
  if (material.preconsolidation_pressure && material.attraction.value_or(0) > *material.preconsolidation_pressure)
    refuse(checked, "attraction", *material.attraction, " is above the preconsolidation pressure",
           fmt::format("from 0 to {} [Pa]", *material.preconsolidation_pressure));
}

} // namespace

void check_materials(const Case& study, Reading& reading) {
  for (const auto& [name, material] : study.materials) {
    const Checked checked{study, name, material, reading};
    for (const LawKey& key : law_keys())
      check_key(checked, key);
    check_values(checked);
  }
}

} // namespace settle::exchange
