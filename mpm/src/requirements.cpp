#include "settle/mpm/requirements.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/ranges.h>

#include "settle/exchange/errors.hpp"
#include "settle/exchange/fitting_size.hpp"
#include "settle/mpm/material.hpp"
#include "stage_requirements.hpp"

namespace settle::mpm {

namespace {

template <class Enum>
std::string quoted(Enum value) {
  return fmt::format("\"{}\"", exchange::name_of(value));
}

/// What there is to know of an element here.
struct ElementKind {
  int dimension = 2;
  std::vector<int> point_counts; ///< that it can be given, the usual one first
  std::string why;               ///< what these have in common, if there are several
  /// Of the same dimension, with every basis; none if it is that itself.
  std::optional<exchange::MpmElement> box;
};

ElementKind kind_of(exchange::MpmElement element) {
  switch (element) {
  case exchange::MpmElement::triangle:
    return {2, {3}, "", exchange::MpmElement::quadrilateral};
  case exchange::MpmElement::quadrilateral:
    return {2, {4, 9, 16}, ": as many side by side as on top of each other", {}};
  case exchange::MpmElement::tetrahedron:
    return {3, {4}, "", exchange::MpmElement::hexahedron};
  case exchange::MpmElement::hexahedron:
    break;
  }
  return {3, {8, 27, 64}, ": as many along one axis as along the others", {}};
}

void require_element_of_the_dimension(const exchange::Case& study) {
  using enum exchange::MpmElement;
  const int dimension = study.geometry.dimension;
  if (kind_of(study.mpm.element).dimension == dimension) return;
  const auto [simplex, box] = dimension == 2 ? std::pair{triangle, quadrilateral} : std::pair{tetrahedron, hexahedron};
  throw exchange::InputError(
      {.where = study.where("mpm.element"),
       .what = fmt::format("the case has {} dimensions, mpm.element has {}", dimension, 5 - dimension),
       .given = fmt::format("{} with geometry.dimension = {}", quoted(study.mpm.element), dimension),
       .allowed = fmt::format("{} or {}", quoted(simplex), quoted(box)),
       .remedy = fmt::format("set mpm.element = {}, or geometry.dimension = {}", quoted(box), 5 - dimension)});
}

void require_basis_of_the_element(const exchange::Case& study) {
  const auto linear = exchange::Basis::linear;
  const ElementKind kind = kind_of(study.mpm.element);
  if (!kind.box || study.mpm.basis == linear) return;
  throw exchange::InputError(
      {.where = study.where("mpm.basis"),
       .what = fmt::format("the basis {} is one of elements {}", quoted(study.mpm.basis), quoted(*kind.box)),
       .given = fmt::format("{} with mpm.element = {}", quoted(study.mpm.basis), quoted(study.mpm.element)),
       .allowed = fmt::format("{} with this element", quoted(linear)),
       .remedy = fmt::format("set mpm.element = {}, or mpm.basis = {}", quoted(*kind.box), quoted(linear))});
}

/// Simplices take their Gauss points, the others a lattice of 2, 3 or 4 a side: a single one does not resist
/// hourglassing.
void require_points_that_fit(const exchange::Case& study) {
  const int count = study.mpm.points_per_element.value_or(0);
  const ElementKind kind = kind_of(study.mpm.element);
  if (std::find(kind.point_counts.begin(), kind.point_counts.end(), count) != kind.point_counts.end()) return;
  throw exchange::InputError(
      {.where = study.where("mpm.points_per_element"),
       .what = fmt::format("an element {} cannot be given this number of points", quoted(study.mpm.element)),
       .given = std::to_string(count),
       .allowed = fmt::format("{}{}", fmt::join(kind.point_counts, ", "), kind.why),
       .remedy = fmt::format("set mpm.points_per_element = {}", kind.point_counts.front())});
}

/// Options that are not for every law, layer by layer.
void require_law_that_fits(const exchange::Case& study, const exchange::Material& material) {
  const auto refuse = [&](const char* key, const char* laws, const char* why) {
    throw exchange::InputError({.where = study.where(key),
                                .what = fmt::format("{} is an option of {}", key, laws),
                                .given = fmt::format("{} = true with law = {}", key, quoted(material.law)),
                                .allowed = fmt::format("false: {}", why),
                                .remedy = fmt::format("set {} = false, or the material's law = \"rate\"", key)});
  };
  const bool is_rate = material.law == exchange::Law::rate;
  const char* by_deformation = "hyperelastic stress follows from the deformation alone";
  if (study.mpm.average_stress && is_soil(material.law))
    refuse("mpm.average_stress", "the law \"rate\"", "an average of stresses does not belong to the points' states");
  if (study.mpm.average_stress && !is_rate) refuse("mpm.average_stress", "the law \"rate\"", by_deformation);
  if (study.mpm.jaumann && !is_rate && !is_soil(material.law))
    refuse("mpm.jaumann", "the law \"rate\" and of soils", by_deformation);
}

/// Cam-clay has no stiffness where its pressure, with the attraction, is zero.
void require_pressure(const exchange::Case& study, const exchange::Material& material, double pressure,
                      const std::string& where, const std::string& remedy) {
  const double sum = pressure + material.attraction.value_or(0.0);
  if (material.law != exchange::Law::cam_clay || sum > 0.0) return;
  throw exchange::InputError({.where = study.where(where),
                              .what = "cam-clay has no stiffness without pressure",
                              .given = fmt::format("pressure and attraction at the start are {:g} Pa together", sum),
                              .allowed = "above 0 Pa",
                              .remedy = remedy});
}

/// What the layers of a body are made of. Points are placed without stress.
void require_materials_that_fit(const exchange::Case& study) {
  for (int layer = 1; layer <= study.construction.layers; ++layer) {
    const exchange::Material& material = study.material_of(layer);
    require_law_that_fits(study, material);
    require_pressure(study, material, 0.0, "material",
                     "give the material an attraction: points are placed stress-free");
  }
}

/// Single points take strain in steps.
void require_point_that_fits(const exchange::Case& study) {
  const exchange::Material& material = study.fill();
  if (material.law == exchange::Law::hencky || material.law == exchange::Law::neo_hookean)
    throw exchange::InputError({.where = study.where(fmt::format("material.{}.law", study.construction.material)),
                                .what = "single material points are led through increments of strain",
                                .given = quoted(material.law),
                                .allowed = "\"rate\" and the laws of soils",
                                .remedy = "take another law, or another shape"});
  const std::vector<double>& stress = study.initial.stress;
  require_pressure(study, material, -(stress[0] + stress[1] + stress[2]) / 3.0, "initial.stress",
                   "set initial.stress to a compression, or give the material an attraction");
}

/// Points and functions of B-splines along one horizontal axis of a column.
struct Across {
  int elements, points;

  [[nodiscard]] int functions() const { return elements + 2; }
  [[nodiscard]] bool has_fewer_points() const { return points < functions(); }
};

/// B-splines that points do not feel, nor their domains. Full cells distribute their force over all functions, points
/// move only what they feel of it: where there are fewer points side by side than functions, an explicit stage does not
/// come to rest. Where there are fewer along both horizontal axes, a product of two functions, each of which is zero at
/// all points (or on the average over all domains), is a motion without resistance, and no quasi-static increment has a
/// solution.
void require_points_that_feel_all_splines(const exchange::Case& study, const exchange::ElementCounts& counts) {
  const auto& mpm = study.mpm;
  if (mpm.basis != exchange::Basis::b_spline && mpm.basis != exchange::Basis::b_spline_gimp) return;
  const int dimension = study.geometry.dimension;
  const int per_side = static_cast<int>(std::lround(std::pow(*mpm.points_per_element, 1.0 / dimension)));
  std::vector<Across> axes{{counts.across, counts.across * per_side}};
  if (dimension == 3) axes.push_back({counts.deep, counts.deep * per_side});
  const auto too_few = std::find_if(axes.begin(), axes.end(), std::mem_fn(&Across::has_fewer_points));
  if (too_few == axes.end()) return;
  const bool is_static = mpm.scheme == exchange::Scheme::quasi_static;
  const bool unresisted =
      dimension == 3 && std::all_of(axes.begin(), axes.end(), std::mem_fn(&Across::has_fewer_points));
  if (is_static ? !unresisted : mpm.integration != exchange::Integration::mixed) return;
  throw exchange::InputError(
      {.where = study.where(is_static ? "mpm.points_per_element" : "mpm.integration"),
       .what = is_static
                   ? "B-splines with fewer points than functions across the column leave a motion without resistance"
                   : "B-splines over full cells do not come to rest with fewer points across the column than "
                     "functions",
       .given = fmt::format("{} points, {} functions across {} element", too_few->points, too_few->functions(),
                            too_few->elements),
       .allowed = is_static ? "as many points as functions along one horizontal axis"
                            : "as many points as functions, or another integration or scheme",
       .remedy = fmt::format("set {}mpm.points_per_element = {}, or take a wider column",
                             is_static ? "" : "mpm.integration = \"points\", ", dimension == 2 ? 9 : 27)});
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

/// A section is extruded by whole elements.
void require_depth_that_fits(const exchange::Case& study) {
  const double depth = *study.geometry.depth, deep = depth / study.mpm.element_size;
  const double slices = std::max(1.0, std::round(deep));
  if (std::abs(deep - slices) > 1e-6 * slices)
    throw exchange::InputError({.where = study.where("geometry.depth"),
                                .what = "the depth is no multiple of mpm.element_size",
                                .given = fmt::format("{:g} m with elements of {:g} m", depth, study.mpm.element_size),
                                .allowed = "whole elements from one end wall to the other",
                                .remedy = fmt::format("set geometry.depth = {:g}", slices * study.mpm.element_size)});
}

/// Along the extrusion full cells distribute their force by other shares than points feel it.
void require_splines_that_rest(const exchange::Case& study) {
  const auto& mpm = study.mpm;
  if (study.geometry.dimension == 2 || mpm.basis != exchange::Basis::b_spline ||
      mpm.scheme != exchange::Scheme::explicit_dynamic || mpm.integration != exchange::Integration::mixed)
    return;
  throw exchange::InputError({.where = study.where("mpm.integration"),
                              .what = "explicit B-splines over full cells do not come to rest in an extruded section",
                              .given = "mpm.integration = \"mixed\" with mpm.scheme = \"explicit\"",
                              .allowed = "\"points\", or another basis or scheme",
                              .remedy = "set mpm.integration = \"points\""});
}

/// Cells on a slope empty because their points go sideways, and are not what is missing.
void require_refill_by_rows(const exchange::Case& study) {
  if (study.construction.convention != exchange::Convention::refill ||
      study.mpm.refill != exchange::RefillRule::element)
    return;
  throw exchange::InputError(
      {.where = study.where("mpm.refill"),
       .what =
           "what is drawn is refilled in rows of points: an empty element on a slope is no measure of what is missing",
       .given = "mpm.refill = \"element\" with construction.convention = \"refill\"",
       .allowed = "\"sub-element\"; for a column also \"element\"",
       .remedy = "set mpm.refill = \"sub-element\""});
}

/// What polygons and a motion ask for that is not there.
void require_polygons_that_fit(const exchange::Case& study) {
  if (const auto box = kind_of(study.mpm.element).box)
    throw exchange::InputError(
        {.where = study.where("mpm.element"),
         .what = fmt::format("polygons are filled by the lattice of a {}'s points", exchange::name_of(*box)),
         .given = fmt::format("mpm.element = {}", quoted(study.mpm.element)),
         .allowed = quoted(*box),
         .remedy = fmt::format("set mpm.element = {}", quoted(*box))});
  const bool is_solid = study.geometry.dimension == 3;
  if (is_solid && !study.geometry.varies_along_y()) require_depth_that_fits(study);
  require_refill_by_rows(study);
  require_splines_that_rest(study);
  require_stages_that_fit(study);
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
  if (study.geometry.shape == exchange::Shape::point) return require_point_that_fits(study);
  require_element_of_the_dimension(study);
  require_points_that_fit(study);
  require_basis_of_the_element(study);
  require_materials_that_fit(study);
  require_threads(study);
  if (study.geometry.drawn()) return require_polygons_that_fit(study);
  const auto counts = exchange::count_elements(study, "mpm.element_size", study.mpm.element_size);
  require_points_that_feel_all_splines(study, counts);
}

} // namespace settle::mpm
