#include "field_svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "chart_frame.hpp"
#include "raster.hpp"
#include "svg_path.hpp"

namespace settle::compare::report {

namespace {

using exchange::PlaneBox;
using exchange::PlanePoint;

// Pixels of the page.
constexpr double widest = 284.0, highest = 380.0; // three beside each other on a page
constexpr double slenderest = 1.0 / 6.0;          // width over height
constexpr double left = 56.0, right = 12.0, top = 8.0, below = 46.0;
constexpr double bar_width = 260.0, bar_height = 14.0, bar_margin = 26.0;
// Of the image in one of the page: for screens and print that show more, as far as the image stays small.
constexpr std::array finenesses{2.0, 1.4, 1.0};
constexpr std::size_t small_image = 18000; // characters
constexpr int colours = 128;               // neighbours cannot be told apart

std::vector<Colour> palette_of(ColourMap map) {
  std::vector<Colour> palette{{255, 255, 255}}; // the background, transparent
  for (int i = 0; i < colours; ++i)
    palette.push_back(colour_at(map, (i + 0.5) / colours));
  return palette;
}

std::uint8_t entry_of(double value, const ValueRange& scale) {
  const double share = (value - scale.lowest) / (scale.highest - scale.lowest);
  return static_cast<std::uint8_t>(1 + std::clamp(static_cast<int>(share * colours), 0, colours - 1));
}

Raster raster_of(const PanelFrame& frame, const FieldLeg& leg, const ValueRange& scale, double fineness) {
  const PlaneBox& view = frame.view;
  Raster raster(view, {(view.highest[0] - view.lowest[0]) / (fineness * frame.width),
                       (view.highest[1] - view.lowest[1]) / (fineness * frame.height)});
  for (const Patch& patch : leg.patches)
    raster.fill(patch.corners, entry_of(patch.value, scale));
  for (const Spot& spot : leg.spots)
    raster.stamp(spot.at, spot.radius, entry_of(spot.value, scale));
  return raster;
}

/// The finest image that is small; the coarsest where none is.
std::string address_of(const PanelFrame& frame, const FieldLeg& leg, const ValueRange& scale, ColourMap map) {
  std::string address;
  for (const double fineness : finenesses) {
    address = data_address(png(raster_of(frame, leg, scale, fineness), palette_of(map)));
    if (address.size() <= small_image) break;
  }
  return address;
}

std::string image(double x, double y, double width, double height, const std::string& address) {
  return fmt::format(R"(<image x="{}" y="{}" width="{}" height="{}" preserveAspectRatio="none" href="{}"/>)",
                     short_coordinate(x), short_coordinate(y), short_coordinate(width), short_coordinate(height),
                     address);
}

/// `access`: attributes that say what it is to those who do not see it.
std::string svg(double width, double height, const std::string& access, const std::string& content) {
  return fmt::format(R"(<svg viewBox="0 0 {0} {1}" width="{0}" {2} font-size="12" fill="#333">{3}</svg>)",
                     short_coordinate(width), short_coordinate(height), access, content);
}

std::string design_svg(const PanelFrame& frame, const ChartAxis& x, const ChartAxis& y) {
  std::string path;
  for (const std::vector<PlanePoint>& outline : frame.design) {
    for (std::size_t i = 0; i < outline.size(); ++i)
      path += fmt::format("{}{} {}", i == 0 ? "M" : "L", short_coordinate(x.pixel(outline[i][0])),
                          short_coordinate(y.pixel(outline[i][1])));
    path += "Z";
  }
  return fmt::format(R"(<path d="{}" fill="none" stroke="#777" stroke-width="0.7" stroke-dasharray="3 3"/>)", path);
}

std::vector<std::vector<PlanePoint>> outlines_of(const exchange::Case& study) {
  std::vector<std::vector<PlanePoint>> outlines;
  if (study.geometry.shape == exchange::Shape::column) {
    const double width = study.geometry.width, height = study.geometry.height;
    return {{{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}}};
  }
  for (const exchange::Polygon& polygon : study.geometry.polygons) {
    outlines.emplace_back();
    for (const auto& corner : polygon.corners)
      outlines.back().push_back({corner[0], corner[1]});
  }
  return outlines;
}

} // namespace

PanelFrame panel_frame(const RunOutcome& run, const FieldPicture& picture) {
  PanelFrame frame;
  frame.view = view_of(run, picture);
  frame.design = outlines_of(run.study);
  const double width = frame.view.highest[0] - frame.view.lowest[0];
  const double height = frame.view.highest[1] - frame.view.lowest[1];
  const double scale = std::min(widest / width, highest / height);
  frame.height = scale * height;
  frame.width = std::max(scale * width, slenderest * frame.height);
  frame.stretch = frame.width / (scale * width);
  return frame;
}

std::string panel_svg(const PanelFrame& frame, const FieldLeg& leg, const ValueRange& scale, ColourMap map,
                      const std::string& name) {
  const ChartAxis x{.lowest = frame.view.lowest[0],
                    .highest = frame.view.highest[0],
                    .from = left,
                    .to = left + frame.width,
                    .title = "x",
                    .unit = "m"};
  const ChartAxis y{.lowest = frame.view.lowest[1],
                    .highest = frame.view.highest[1],
                    .from = top + frame.height,
                    .to = top,
                    .title = "Height",
                    .unit = "m"};
  const std::string address = address_of(frame, leg, drawn_scale(scale), map);
  const std::string access = fmt::format(R"(role="img" aria-label="{}")", escaped(name));
  return svg(panel_width(frame), top + frame.height + below, access,
             image(left, top, frame.width, frame.height, address) + design_svg(frame, x, y) + axes_svg(x, y));
}

double panel_width(const PanelFrame& frame) {
  return left + frame.width + right;
}

std::string colour_bar_svg(const ValueRange& scale, ColourMap map, const std::string& title, const std::string& unit) {
  const ValueRange shown = drawn_scale(scale);
  const ChartAxis axis{.lowest = shown.lowest,
                       .highest = shown.highest,
                       .from = bar_margin,
                       .to = bar_margin + bar_width,
                       .title = title,
                       .unit = unit};
  Raster raster({.lowest = {0.0, 0.0}, .highest = {colours, 1.0}}, {1.0, 1.0});
  for (int i = 0; i < colours; ++i)
    raster.stamp({i + 0.5, 0.5}, 0.1, static_cast<std::uint8_t>(1 + i));
  const std::string address = data_address(png(raster, palette_of(map)));
  return svg(bar_width + 2.0 * bar_margin, 2.0 + bar_height + below, "aria-hidden=\"true\"",
             image(bar_margin, 2.0, bar_width, bar_height, address) + axis_svg(axis, 2.0 + bar_height));
}

ValueRange drawn_scale(const ValueRange& scale) {
  if (scale.highest > scale.lowest) return scale;
  const double around = scale.highest == 0.0 ? 1.0 : 0.5 * std::abs(scale.highest);
  return {.lowest = scale.lowest - around, .highest = scale.highest + around};
}

} // namespace settle::compare::report
