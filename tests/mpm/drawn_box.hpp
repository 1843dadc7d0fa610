/// \file
/// Text of cases whose body is a box of layers 0.5 m thick between smooth walls, drawn.
#pragma once

#include <string>

namespace settle::mpm::test {

/// The layers, `width` wide [m].
inline std::string polygons_of_box(int layers, const std::string& width) {
  std::string text = "[geometry]\nshape = \"polygons\"\ndimension = 2\n";
  for (int layer = 1; layer <= layers; ++layer) {
    const std::string low = std::to_string(0.5 * (layer - 1)), high = std::to_string(0.5 * layer);
    text += "[[geometry.polygon]]\nlayer = " + std::to_string(layer) + "\ncorners = [[0.0, " + low + "], [" + width +
            ", " + low + "], [" + width + ", " + high + "], [0.0, " + high + "]]\n";
  }
  return text;
}

/// Rollers on both sides and the base.
inline std::string supports_of_box(int layers, const std::string& width) {
  const std::string top = std::to_string(0.5 * layers);
  return "[[support]]\nfrom = [0.0, " + top + "]\nto = [0.0, 0.0]\nheld = \"x\"\n" +
         "[[support]]\nfrom = [0.0, 0.0]\nto = [" + width + ", 0.0]\nheld = \"y\"\n" + "[[support]]\nfrom = [" + width +
         ", 0.0]\nto = [" + width + ", " + top + "]\nheld = \"x\"\n";
}

} // namespace settle::mpm::test
