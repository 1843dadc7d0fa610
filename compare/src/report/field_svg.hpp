/// \file
/// Field pictures as SVG: axes around an image of pixels, and the bar that says what the colours mean.
#pragma once

#include <string>
#include <vector>

#include "colour_map.hpp"
#include "field_picture.hpp"

namespace settle::compare::report {

/// What all panels of a picture have in common.
struct PanelFrame {
  exchange::PlaneBox view{};                             ///< [m]
  std::vector<std::vector<exchange::PlanePoint>> design; ///< outlines of the design geometry [m]
  double width = 0, height = 0;                          ///< of the plot [pixels]
  double stretch = 1;                                    ///< how many times as large the width is drawn as the height
};

/// The frame of a run's picture, within so many pixels; what is slender is drawn wider than it is.
PanelFrame panel_frame(const RunOutcome& run, const FieldPicture& picture);

/// One solver's field; `name`: what it shows, for those who do not see it.
std::string panel_svg(const PanelFrame& frame, const FieldLeg& leg, const ValueRange& scale, ColourMap map,
                      const std::string& name);
/// Width of such a drawing [pixels].
double panel_width(const PanelFrame& frame);

/// The colours of a scale, with values; not read aloud, as the panels say their ranges themselves.
std::string colour_bar_svg(const ValueRange& scale, ColourMap map, const std::string& title, const std::string& unit);

/// The scale as it is drawn: of a field with one value all over it has room on both sides of it.
ValueRange drawn_scale(const ValueRange& scale);

} // namespace settle::compare::report
