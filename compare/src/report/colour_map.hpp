/// \file
/// Colours of a value: perceptually even, readable with any deficiency of colour vision and in print without colours.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace settle::compare::report {

/// Red, green, blue [sRGB].
using Colour = std::array<std::uint8_t, 3>;

enum class ColourMap {
  even,     ///< from dark violet to light yellow over [0, 1]: lightness and hue rise in proportion
  two_sided ///< from blue over near white (1/2) to brown: the sign is seen, equal sizes are equally far from white
};

/// The colour at `share` in [0, 1] of the map.
Colour colour_at(ColourMap map, double share);

/// "#1a2b3c"
std::string hexadecimal(const Colour& colour);

} // namespace settle::compare::report
