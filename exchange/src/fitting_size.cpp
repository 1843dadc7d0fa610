#include "settle/exchange/fitting_size.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "settle/exchange/errors.hpp"

namespace settle::exchange {

namespace {

/// Lengths in case files are decimal numbers with a few digits; grids are stretched to fit, so this is not an error.
constexpr double relative_slack = 1e-6;

struct Length {
  std::string name;
  double value = 0; ///< [m]
};

bool divides(double size, double length) {
  const double ratio = length / size;
  return ratio > 0.5 && std::abs(ratio - std::round(ratio)) <= relative_slack * ratio;
}

bool divides_all(double size, const std::vector<Length>& lengths) {
  return std::all_of(lengths.begin(), lengths.end(), [&](const Length& l) { return divides(size, l.value); });
}

std::vector<Length> lengths_to_divide(const Case& study) {
  std::vector<Length> lengths{{"layer height", study.layer_thickness()}, {"width", study.geometry.width}};
  if (study.geometry.dimension == 3) lengths.push_back({"depth", study.geometry.depth.value_or(study.geometry.width)});
  return lengths;
}

/// The largest size below and the smallest size above `given` that divide all lengths, as a text.
std::string nearest_fitting_sizes(const std::vector<Length>& lengths, double given) {
  constexpr int subdivisions_tried = 1000;
  const double thickness = lengths.front().value;
  const int around = std::max(1, static_cast<int>(thickness / given));
  const auto first_fit = [&](int from, int to, int step, auto&& on_the_right_side) -> std::string {
    for (int n = from; n != to; n += step)
      if (on_the_right_side(thickness / n) && divides_all(thickness / n, lengths))
        return fmt::format("{:.6g} m", thickness / n);
    return {};
  };
  const std::string larger = first_fit(around, 0, -1, [&](double size) { return size > given; });
  const std::string smaller =
      first_fit(around, around + subdivisions_tried, 1, [&](double size) { return size < given; });
  return larger.empty() || smaller.empty() ? larger + smaller : larger + " or " + smaller;
}

std::string listed(const std::vector<Length>& lengths) {
  std::string text;
  for (const Length& length : lengths)
    text += fmt::format("{}{} {:.6g} m", text.empty() ? "" : ", ", length.name, length.value);
  return text;
}

} // namespace

ElementCounts count_elements(const Case& study, const std::string& key, double size) {
  const std::vector<Length> lengths = lengths_to_divide(study);
  for (const Length& length : lengths) {
    if (divides(size, length.value)) continue;
    const std::string nearest = nearest_fitting_sizes(lengths, size);
    throw InputError({.where = study.where(key),
                      .what = fmt::format("the {} of {:.6g} m is no multiple of {}", length.name, length.value, key),
                      .given = fmt::format("{} = {:.6g}, with {}", key, size, listed(lengths)),
                      .allowed = nearest.empty() ? "a size that divides all of these" : "nearest that fit: " + nearest,
                      .remedy = nearest.empty() ? "choose a layer height and a width that have a common divisor"
                                                : "choose one of these, or change geometry.width or "
                                                  "construction.layers"});
  }
  const auto count = [&](double length) { return static_cast<int>(std::lround(length / size)); };
  return {.per_layer = count(lengths[0].value),
          .across = count(lengths[1].value),
          .deep = lengths.size() > 2 ? count(lengths[2].value) : 1};
}

} // namespace settle::exchange
