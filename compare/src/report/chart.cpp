#include "chart.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "format.hpp"
#include "html_table.hpp"
#include "svg_path.hpp"
#include "templates.hpp"

namespace settle::compare::report {

namespace {

// Pixels: the plot lies where gnuplot's figures have theirs.
constexpr double width = 540.0, left = 80.0, right = 18.0, top = 12.0, plot_height = 430.0, below = 52.0;

/// From zero to the data, with a little room beyond.
void reach(ChartAxis& axis, double ChartPoint::*coordinate_of, const std::vector<ChartSeries>& series) {
  axis.lowest = axis.highest = 0.0;
  for (const ChartSeries& each : series)
    for (const auto& piece : each.pieces)
      for (const ChartPoint& point : piece) {
        axis.lowest = std::min(axis.lowest, point.*coordinate_of);
        axis.highest = std::max(axis.highest, point.*coordinate_of);
      }
  if (axis.lowest == axis.highest) axis.highest = 1.0;
  const double room = 0.04 * (axis.highest - axis.lowest);
  if (axis.lowest < 0.0) axis.lowest -= room;
  if (axis.highest > 0.0) axis.highest += room;
}

/// A line for each piece, without points that nobody would miss, or a dot for each point.
std::vector<SvgLine> lines_of(const ChartSeries& series, const ChartAxis& x, const ChartAxis& y) {
  constexpr double unseen = 0.5; // pixels
  std::vector<SvgLine> lines;
  for (const auto& piece : series.pieces) {
    SvgLine line;
    for (const ChartPoint& point : piece)
      line.points.push_back({x.pixel(point.x), y.pixel(point.y)});
    if (series.line && !piece.empty()) lines.push_back(simplified(line, unseen));
    for (std::size_t i = 0; !series.line && i < piece.size(); ++i)
      lines.push_back({.points = {line.points[i]}, .closed = false});
  }
  return lines;
}

std::string series_svg(const ChartSeries& series, const ChartAxis& x, const ChartAxis& y) {
  const char* kind = !series.line ? "spots" : series.dashed ? "dashes" : "line";
  return fmt::format(R"(<path class={} stroke="{}" d="{}"/>)", kind, series.colour, path_text(lines_of(series, x, y)));
}

std::string chart_svg(const Chart& chart) {
  std::string content;
  if (chart.x.lowest < 0.0)
    content += fmt::format(R"(<path class="axis" d="M{0} {1}V{2}"/>)", short_coordinate(chart.x.pixel(0.0)),
                           short_coordinate(chart.y.from), short_coordinate(chart.y.to));
  content += axes_svg(chart.x, chart.y);
  for (const ChartSeries& each : chart.series)
    content += series_svg(each, chart.x, chart.y);
  return fmt::format(R"(<svg viewBox="0 0 {} {}" role="img" aria-label="{}">)"
                     R"({}</svg>)",
                     short_coordinate(width), short_coordinate(top + plot_height + below), escaped(chart.title),
                     content);
}

data key_of(const Chart& chart) {
  data list(data::type::list);
  for (const ChartSeries& each : chart.series) {
    data entry("label", each.label);
    entry.set("colour", each.colour);
    entry.set("kind", std::string(!each.line ? "spot" : each.dashed ? "dashed" : "line"));
    list.push_back(entry);
  }
  return list;
}

} // namespace

void drop_points_that_are_not_finite(ChartSeries& series, std::vector<std::string>& missing) {
  std::size_t dropped = 0;
  for (auto& piece : series.pieces)
    dropped += std::erase_if(
        piece, [](const ChartPoint& point) { return !std::isfinite(point.x) || !std::isfinite(point.y); });
  if (dropped > 0)
    missing.push_back(fmt::format("{}: {} points have no value and are left out", series.label, dropped));
}

std::string chart_html(Chart chart) {
  reach(chart.x, &ChartPoint::x, chart.series);
  if (!chart.keeps_y) reach(chart.y, &ChartPoint::y, chart.series);
  chart.x.from = left;
  chart.x.to = width - right;
  chart.y.from = top + plot_height;
  chart.y.to = top;
  data figure("id", chart.id);
  figure.set("title", chart.title);
  figure.set("caption", text_or_nothing(chart.caption));
  figure.set("svg", chart.series.empty() ? data(false) : data(chart_svg(chart)));
  figure.set("key", key_of(chart));
  data missing(data::type::list);
  for (const std::string& sentence : chart.missing)
    missing.push_back(data("sentence", printable(sentence)));
  figure.set("missing", chart.missing.empty() ? data(false) : data("sentences", missing));
  return render(templates::chart, figure);
}

} // namespace settle::compare::report
