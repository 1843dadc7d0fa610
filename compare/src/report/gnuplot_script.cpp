#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "chart_frame.hpp"
#include "curve_styles.hpp"
#include "format.hpp"
#include "gnuplot.hpp"

namespace settle::compare::report {

namespace {

constexpr int left_margin = 80; // pixels; with less room than " 0.05" needs, gnuplot leaves the title of the axis out

std::string data_block(const PlotCurve& curve, std::size_t index) {
  std::string block = fmt::format("$curve{} << END_OF_DATA\n", index);
  for (const Segment& segment : curve.profile) {
    for (const ProfilePoint& point : segment)
      block += fmt::format("{:.6g} {:.6g}\n", point.value, point.height);
    block += "\n"; // a blank line: the layers are not joined
  }
  return block + "END_OF_DATA\n";
}

std::string drawing(const CurveStyle& style) {
  if (style.line) return fmt::format("with lines lw 1.4 dt {} lc rgb '{}'", style.dash_type, style.colour);
  return fmt::format("with points pt {} ps {} lc rgb '{}'", style.point_type, style.point_size, style.colour);
}

std::string plot_command(const Plot& plot) {
  const std::vector<CurveStyle> styles = styles_of(plot);
  std::string command = "plot ";
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    command += fmt::format("{}$curve{} using 1:2 {} {}", i == 0 ? "" : ", \\\n  ", i, drawing(styles[i]),
                           key_text(plot.curves[i].label).title);
  }
  return command + "\n";
}

/// From zero, but of densities, to the data with a little room beyond.
ChartAxis values_axis(const Plot& plot) {
  const Axis axis = axis_of(plot.quantity);
  ChartAxis values{.from = left_margin, .to = 522.0, .title = axis.title + axis.sense, .unit = axis.unit};
  const bool from_zero = plot.quantity != exchange::Quantity::density;
  values.lowest = from_zero ? 0.0 : std::numeric_limits<double>::infinity();
  values.highest = from_zero ? 0.0 : -std::numeric_limits<double>::infinity();
  for (const PlotCurve& curve : plot.curves)
    for (const Segment& segment : curve.profile)
      for (const ProfilePoint& point : segment) {
        values.lowest = std::min(values.lowest, point.value);
        values.highest = std::max(values.highest, point.value);
      }
  if (!std::isfinite(values.lowest)) values.lowest = values.highest = 0.0; // no values
  if (values.lowest == values.highest) values.highest += 1.0;
  const double room = 0.04 * (values.highest - values.lowest);
  if (!from_zero || values.lowest < 0.0) values.lowest -= room;
  if (!from_zero || values.highest > 0.0) values.highest += room;
  return values;
}

std::string tics(const AxisText& text) {
  std::vector<std::string> tics;
  for (std::size_t i = 0; i < text.values.size(); ++i)
    tics.push_back(fmt::format("{} {:.6g}", gnuplot_text(text.labels[i]), text.values[i]));
  return fmt::format("{}", fmt::join(tics, ", "));
}

std::string axes(const Plot& plot) {
  constexpr int most = 6; // labels, with room between them
  const ChartAxis values = values_axis(plot);
  const AxisText text = axis_text(values, most);
  return fmt::format("set border 3 lw 1 lc rgb '#555555'\n"
                     "set tics nomirror out scale 0.6\n"
                     "set grid xtics lt 1 lw 0.8 lc rgb '#E4E4E4'\n"
                     "set xlabel {} offset 0,0.2\n"
                     "set ylabel {} offset 1.2,0\n"
                     "set xrange [{:.6g}:{:.6g}]\n"
                     "set xtics ({})\n"
                     "set yrange [0:{:.6g}]\n",
                     gnuplot_text(text.title), gnuplot_text(plot.height_title), values.lowest, values.highest,
                     tics(text), 1.02 * plot.top);
}

std::string layer_lines(const Plot& plot) {
  std::string text;
  for (const double level : plot.interfaces) {
    text += fmt::format("set arrow from graph 0, first {0:.6g} to graph 1, first {0:.6g} nohead back lt 1 lw 0.8 "
                        "dt 3 lc rgb '#BBBBBB'\n",
                        level);
  }
  return text;
}

std::string stage_labels(const Plot& plot) {
  std::string text;
  for (const StageLabel& label : plot.stage_labels) {
    text +=
        fmt::format("set label {} at {:.6g}, {:.6g} left offset 0.6,-0.1 font 'sans-serif,13' tc rgb '#444444' front\n",
                    gnuplot_text(label.text), label.at.value, label.at.height);
  }
  return text;
}

} // namespace

std::string gnuplot_script(const Plot& plot) {
  std::size_t key_rows = 0;
  for (const PlotCurve& curve : plot.curves)
    key_rows += key_text(curve.label).rows;
  std::string script = gnuplot_canvas(key_rows, left_margin) + axes(plot) + layer_lines(plot) + stage_labels(plot);
  for (std::size_t i = 0; i < plot.curves.size(); ++i)
    script += data_block(plot.curves[i], i);
  return script + plot_command(plot);
}

} // namespace settle::compare::report
