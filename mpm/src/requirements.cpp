#include "settle/mpm/requirements.hpp"

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"
#include "settle/exchange/fitting_size.hpp"

namespace settle::mpm {

namespace {

/// One key that has to have one value.
struct Only {
  const char* key;
  std::string given;
  std::string allowed;
};

void require(const exchange::Case& study, const Only& only) {
  if (only.given == only.allowed) return;
  throw exchange::InputError(
      {.where = study.where(only.key),
       .what = fmt::format("settle-mpm of this version cannot run {} = {}", only.key, only.given),
       .given = only.given,
       .allowed = only.allowed,
       .remedy = fmt::format("set {} = {}", only.key, only.allowed)});
}

template <class Enum>
std::string quoted(Enum value) {
  return fmt::format("\"{}\"", exchange::name_of(value));
}

void require_law_that_fits(const exchange::Case& study) {
  if (study.fill().law == exchange::Law::rate) return;
  const auto refuse = [&](const char* key) {
    throw exchange::InputError({.where = study.where(key),
                                .what = fmt::format("{} is an option of the law \"rate\"", key),
                                .given = fmt::format("{} = true with law = {}", key, quoted(study.fill().law)),
                                .allowed = "false: hyperelastic stress follows from the deformation alone",
                                .remedy = fmt::format("set {} = false, or the material's law = \"rate\"", key)});
  };
  if (study.mpm.average_stress) refuse("mpm.average_stress");
  if (study.mpm.jaumann) refuse("mpm.jaumann");
}

} // namespace

void require_solvable(const exchange::Case& study) {
  require(study, {"geometry.dimension", std::to_string(study.geometry.dimension), "2"});
  require(study, {"mpm.element", quoted(study.mpm.element), quoted(exchange::MpmElement::triangle)});
  require(study, {"mpm.points_per_element", std::to_string(*study.mpm.points_per_element), "3"});
  require(study, {"mpm.basis", quoted(study.mpm.basis), quoted(exchange::Basis::linear)});
  require_law_that_fits(study);
  exchange::count_elements(study, "mpm.element_size", study.mpm.element_size);
}

} // namespace settle::mpm
