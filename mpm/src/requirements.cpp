#include "settle/mpm/requirements.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

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

void require_known_element(const exchange::Case& study) {
  using enum exchange::MpmElement;
  if (study.mpm.element == triangle || study.mpm.element == quadrilateral) return;
  throw exchange::InputError({.where = study.where("mpm.element"),
                              .what = "settle-mpm of this version has elements of the plane only",
                              .given = quoted(study.mpm.element),
                              .allowed = fmt::format("{} or {}", quoted(triangle), quoted(quadrilateral)),
                              .remedy = "set mpm.element to one of these"});
}

void require_basis_of_the_element(const exchange::Case& study) {
  const auto linear = exchange::Basis::linear;
  const auto triangle = exchange::MpmElement::triangle, quadrilateral = exchange::MpmElement::quadrilateral;
  if (study.mpm.element != triangle || study.mpm.basis == linear) return;
  throw exchange::InputError(
      {.where = study.where("mpm.basis"),
       .what = fmt::format("the basis {} is one of quadrilaterals", quoted(study.mpm.basis)),
       .given = fmt::format("{} with mpm.element = {}", quoted(study.mpm.basis), quoted(triangle)),
       .allowed = fmt::format("{} with this element", quoted(linear)),
       .remedy = fmt::format("set mpm.element = {}, or mpm.basis = {}", quoted(quadrilateral), quoted(linear))});
}

/// Triangles take three points, quadrilaterals the square of 2, 3 or 4: a single one does not resist hourglassing.
void require_points_that_fit(const exchange::Case& study) {
  const int count = study.mpm.points_per_element.value_or(0);
  const bool triangle = study.mpm.element == exchange::MpmElement::triangle;
  if (triangle ? count == 3 : count == 4 || count == 9 || count == 16) return;
  throw exchange::InputError(
      {.where = study.where("mpm.points_per_element"),
       .what = fmt::format("an element {} cannot be given this number of points", quoted(study.mpm.element)),
       .given = std::to_string(count),
       .allowed = triangle ? "3" : "4, 9 or 16: as many side by side as on top of each other",
       .remedy = fmt::format("set mpm.points_per_element = {}", triangle ? 3 : 4)});
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

/// Full cells distribute their force over all functions, points move only what they feel of it: where there are fewer
/// points side by side than functions, an explicit stage does not come to rest.
void require_points_that_feel_all_splines(const exchange::Case& study, int across) {
  const auto& mpm = study.mpm;
  if (mpm.basis != exchange::Basis::b_spline || mpm.integration != exchange::Integration::mixed ||
      mpm.scheme != exchange::Scheme::explicit_dynamic)
    return;
  const int points = across * static_cast<int>(std::lround(std::sqrt(*mpm.points_per_element)));
  if (points >= across + 2) return;
  throw exchange::InputError(
      {.where = study.where("mpm.integration"),
       .what = "B-splines over full cells do not come to rest with fewer points across the width than functions",
       .given = fmt::format("{} points, {} functions across {} element", points, across + 2, across),
       .allowed = "as many points as functions, or another integration or scheme",
       .remedy = "set mpm.integration = \"points\", mpm.points_per_element = 9, or take a wider column"});
}

void require_threads(const exchange::Case& study) {
  const int most = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (study.mpm.threads <= most) return;
  throw exchange::InputError({.where = study.where("mpm.threads"),
                              .what = "this machine has fewer processors",
                              .given = std::to_string(study.mpm.threads),
                              .allowed = fmt::format("1 ... {}", most),
                              .remedy = fmt::format("set mpm.threads = {}", most)});
}

/// What polygons and a motion ask for that is not there.
void require_polygons_that_fit(const exchange::Case& study) {
  if (study.mpm.element != exchange::MpmElement::quadrilateral)
    throw exchange::InputError({.where = study.where("mpm.element"),
                                .what = "polygons are filled by the lattice of a quadrilateral's points",
                                .given = fmt::format("mpm.element = {}", quoted(study.mpm.element)),
                                .allowed = quoted(exchange::MpmElement::quadrilateral),
                                .remedy = "set mpm.element = \"quadrilateral\""});
  if (study.mpm.scheme == exchange::Scheme::quasi_static) return;
  for (std::size_t number = 0; number < study.supports.size(); ++number) {
    if (study.supports[number].motion == exchange::SupportMotion::none) continue;
    const std::string key = fmt::format("support.{}.motion", number);
    throw exchange::InputError({.where = study.where(key),
                                .what = "the explicit scheme holds supports still",
                                .given = fmt::format("{} = \"exact\" with mpm.scheme = \"explicit\"", key),
                                .allowed = "\"none\"",
                                .remedy = "set mpm.scheme = \"quasi-static\""});
  }
}

} // namespace

void require_solvable(const exchange::Case& study) {
  require(study, {"geometry.dimension", std::to_string(study.geometry.dimension), "2"});
  require_known_element(study);
  require_points_that_fit(study);
  require_basis_of_the_element(study);
  require_law_that_fits(study);
  require_threads(study);
  if (study.geometry.shape == exchange::Shape::polygons) return require_polygons_that_fit(study);
  const auto counts = exchange::count_elements(study, "mpm.element_size", study.mpm.element_size);
  require_points_that_feel_all_splines(study, counts.across);
}

} // namespace settle::mpm
