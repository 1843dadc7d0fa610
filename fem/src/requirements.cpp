#include "settle/fem/requirements.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"

namespace settle::fem {
namespace {

/// Lengths in case files are decimal numbers with a few digits; cells are stretched to fit, so this is not an error.
constexpr double relative_slack = 1e-6;

struct Length {
  std::string name;
  double value; ///< [m]
};

bool divides(double size, double length) {
  const double ratio = length / size;
  return ratio > 0.5 && std::abs(ratio - std::round(ratio)) <= relative_slack * ratio;
}

bool divides_all(double size, const std::vector<Length>& lengths) {
  return std::all_of(lengths.begin(), lengths.end(), [&](const Length& l) { return divides(size, l.value); });
}

std::vector<Length> lengths_to_divide(const exchange::Case& study) {
  const exchange::Geometry& geometry = study.geometry;
  std::vector<Length> lengths{{"layer height", study.layer_thickness()}, {"width", geometry.width}};
  if (geometry.dimension == 3) lengths.push_back({"depth", geometry.depth.value_or(geometry.width)});
  return lengths;
}

/// The largest size below and the smallest size above `given` that divide all lengths, as a text.
std::string nearest_fitting_sizes(const std::vector<Length>& lengths, double given) {
  constexpr int subdivisions_tried = 1000;
  const double thickness = lengths.front().value;
  const int around = std::max(1, static_cast<int>(thickness / given));
  std::vector<std::string> found;
  for (int n = around; n >= 1 && found.empty(); --n)
    if (thickness / n > given && divides_all(thickness / n, lengths))
      found.push_back(fmt::format("{:.6g} m", thickness / n));
  const std::size_t larger = found.size();
  for (int n = around; n <= around + subdivisions_tried && found.size() == larger; ++n)
    if (thickness / n < given && divides_all(thickness / n, lengths))
      found.push_back(fmt::format("{:.6g} m", thickness / n));
  return fmt::format("{}", fmt::join(found, " or "));
}

std::string listed(const std::vector<Length>& lengths) {
  std::vector<std::string> texts;
  for (const Length& length : lengths)
    texts.push_back(fmt::format("{} {:.6g} m", length.name, length.value));
  return fmt::format("{}", fmt::join(texts, ", "));
}

void require_divisible(const exchange::Case& study, const std::vector<Length>& lengths) {
  const double size = study.fem.element_size;
  const auto misfit =
      std::find_if(lengths.begin(), lengths.end(), [&](const Length& l) { return !divides(size, l.value); });
  if (misfit == lengths.end()) return;
  const std::string nearest = nearest_fitting_sizes(lengths, size);
  throw exchange::InputError(exchange::Complaint{
      .where = study.where("fem.element_size"),
      .what = fmt::format("the {} of {:.6g} m is no multiple of fem.element_size", misfit->name, misfit->value),
      .given = fmt::format("fem.element_size = {:.6g}, with {}", size, listed(lengths)),
      .allowed = nearest.empty() ? std::string("a size that divides all of these") : "nearest that fit: " + nearest,
      .remedy = nearest.empty() ? "choose a layer height and a width that have a common divisor"
                                : "use a size that fits, or change geometry.width or construction.layers"});
}

void require_small_strain(const exchange::Case& study) {
  if (study.fem.kinematics == exchange::Kinematics::small) return;
  throw exchange::InputError(exchange::Complaint{
      .where = study.where("fem.kinematics"),
      .what = "the finite element solver of this version is small strain only",
      .given = fmt::format("fem.kinematics = \"{}\"", exchange::name_of(study.fem.kinematics)),
      .allowed = fmt::format("\"{}\"", exchange::name_of(exchange::Kinematics::small)),
      .remedy =
          "use fem.kinematics = \"small\" (comparisons then use the exact small-strain solution), or solve the case "
          "at finite strain with settle-mpm"});
}

} // namespace

CellCounts cell_counts(const exchange::Case& study) {
  const std::vector<Length> lengths = lengths_to_divide(study);
  require_divisible(study, lengths);
  const auto cells = [&](double length) { return static_cast<unsigned>(std::lround(length / study.fem.element_size)); };
  CellCounts counts;
  counts.per_layer = cells(study.layer_thickness());
  const unsigned vertical = counts.per_layer * static_cast<unsigned>(study.construction.layers);
  counts.along[0] = cells(study.geometry.width);
  if (study.geometry.dimension == 3) counts.along[1] = cells(lengths.back().value);
  counts.along[study.geometry.dimension == 3 ? 2 : 1] = vertical;
  return counts;
}

void require_solvable(const exchange::Case& study) {
  require_small_strain(study);
  cell_counts(study);
}

} // namespace settle::fem
