#include "colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace settle::compare::report {

namespace {

/// Cylindrical coordinates of OKLab (B. Ottosson, 2020), in which equal distances look alike.
struct Look {
  double lightness; ///< 0 black ... 1 white
  double chroma;
  double hue; ///< [degrees]
};

std::uint8_t encoded(double linear) {
  const double inside = std::clamp(linear, 0.0, 1.0);
  const double gamma = inside <= 0.0031308 ? 12.92 * inside : 1.055 * std::pow(inside, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * gamma));
}

Colour srgb(const Look& look) {
  const double angle = look.hue * std::numbers::pi / 180.0;
  const double a = look.chroma * std::cos(angle), b = look.chroma * std::sin(angle);
  const auto cone = [&](double of_a, double of_b) { return std::pow(look.lightness + of_a * a + of_b * b, 3); };
  const double l = cone(0.3963377774, 0.2158037573);
  const double m = cone(-0.1055613458, -0.0638541728);
  const double s = cone(-0.0894841775, -1.2914855480);
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

/// A line in lightness and hue at one chroma, the largest that stays within sRGB all the way.
Look even(double share) {
  return {.lightness = 0.30 + 0.62 * share, .chroma = 0.10, .hue = 310.0 - 215.0 * share};
}

Look two_sided(double share) {
  const double size = std::abs(2.0 * share - 1.0);
  return {.lightness = 0.97 - 0.52 * size, .chroma = 0.11 * size, .hue = share < 0.5 ? 250.0 : 50.0};
}

} // namespace

Colour colour_at(ColourMap map, double share) {
  const double inside = std::clamp(share, 0.0, 1.0);
  return srgb(map == ColourMap::even ? even(inside) : two_sided(inside));
}

std::string hexadecimal(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

} // namespace settle::compare::report
