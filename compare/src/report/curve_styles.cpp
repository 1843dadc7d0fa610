#include "curve_styles.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>

namespace settle::compare::report {

namespace {

constexpr const char* black = "#000000";
constexpr const char* grey = "#6B6B6B";
constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};

const char* colour_number(std::size_t index) {
  return palette[index % palette.size()];
}

bool is_line(const std::string& source) {
  return is_exact(source) || source == "eq-1";
}

/// Half way to black: a line of a run is seen on top of its markers.
std::string darkened(const std::string& colour) {
  const auto channel = [&](std::size_t at) { return std::stoi(colour.substr(at, 2), nullptr, 16) / 2; };
  return fmt::format("#{:02X}{:02X}{:02X}", channel(1), channel(3), channel(5));
}

/// The place of each run in the order in which markers and exact lines mention them; Eq. (1) belongs to no run.
std::map<std::string, std::size_t> order_of_runs(const Plot& plot) {
  std::map<std::string, std::size_t> order;
  for (const PlotCurve& curve : plot.curves) {
    if (curve.source != "eq-1") order.emplace(curve.run, order.size());
  }
  return order;
}

} // namespace

CurveStyle style_of(const std::string& source) {
  if (source == "exact") return {black, true, 1, 0, 0};
  if (is_exact(source)) return {grey, true, 2, 0, 0};
  if (source == "eq-1") return {grey, true, 4, 0, 0};
  if (source == "mpm") return {colour_number(0), false, 1, 7, 0.5};
  if (source == "fem") return {colour_number(1), false, 1, 4, 0.62};
  return {colour_number(2), false, 1, 8, 0.62};
}

std::vector<CurveStyle> styles_of(const Plot& plot) {
  const std::map<std::string, std::size_t> runs = order_of_runs(plot);
  std::map<std::string, std::size_t> references;
  int equations = 0;
  std::vector<CurveStyle> styles;
  for (const PlotCurve& curve : plot.curves) {
    CurveStyle style = style_of(curve.source);
    if (curve.source == "eq-1") {
      style.colour = equations == 0 ? black : grey;
      style.dash_type = 4 - equations % 3;
      ++equations;
    } else if (runs.size() > 1) {
      const std::string colour = colour_number(runs.at(curve.run));
      style.colour = is_line(curve.source) ? darkened(colour) : colour;
    } else if (!is_line(curve.source) && curve.source != "mpm" && curve.source != "fem") {
      style.colour = colour_number(2 + references.emplace(curve.source, references.size()).first->second);
    }
    styles.push_back(std::move(style));
  }
  return styles;
}

} // namespace settle::compare::report
