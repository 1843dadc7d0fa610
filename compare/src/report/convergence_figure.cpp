#include "convergence_figure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "curve_styles.hpp"
#include "gnuplot.hpp"
#include "settle/compare/field_samples.hpp"
#include "settle/compare/refinement_levels.hpp"

namespace settle::compare::report {

namespace {

constexpr int wide_left_margin = 92; // pixels: errors have longer tics than heights

/// A level on logarithmic axes.
struct LevelPoint {
  double size = 0;
  double error = 0;
};

/// The levels that have a place on logarithmic axes: errors, or changes from the level before relative to the value.
std::vector<LevelPoint> drawable(const ConvergenceStudy& study) {
  std::vector<LevelPoint> points;
  for (std::size_t i = 0; i < study.values.size(); ++i) {
    const bool exact = !study.errors.empty();
    if (!exact && i == 0) continue;
    const double error = exact ? study.errors[i] : std::abs((study.values[i] - study.values[i - 1]) / study.values[i]);
    if (error > 0.0 && std::isfinite(error)) points.push_back({study.sizes[i], error});
  }
  return points;
}

/// "MPM, l2 over points: converging, order 1.02"; the axis names the quantity.
std::string label_of(const ConvergenceStudy& study) {
  const exchange::ExpectedConvergence& expected = study.expected;
  std::string text = expected.solver == "mpm" ? "MPM" : "FEM";
  if (study.errors.empty()) text += " against itself";
  if (is_field(expected.quantity)) text += fmt::format(", {} over {}", name_of(expected.norm), name_of(expected.over));
  text += fmt::format(": {}", exchange::name_of(study.finding.verdict));
  const bool floor = study.finding.verdict == exchange::Convergence::floor_limited; // a slope of scatter says nothing
  if (!floor && std::isfinite(study.finding.order)) text += fmt::format(", order {:.2f}", study.finding.order);
  return text;
}

/// Studies of one solver share its colour and differ in the shape of their markers.
CurveStyle style_of_study(const ConvergencePlot& plot, std::size_t index) {
  const std::string& solver = plot.studies[index]->expected.solver;
  CurveStyle style = style_of(solver);
  const auto earlier = std::count_if(plot.studies.begin(), plot.studies.begin() + static_cast<std::ptrdiff_t>(index),
                                     [&](const ConvergenceStudy* study) { return study->expected.solver == solver; });
  style.point_type += 2 * static_cast<int>(earlier); // gnuplot: circle, triangle, ... ; square, circle, ...
  style.point_size = 0.9;
  return style;
}

std::string data_block(const std::string& name, const std::vector<LevelPoint>& points) {
  std::string block = fmt::format("${} << END_OF_DATA\n", name);
  for (const LevelPoint& point : points)
    block += fmt::format("{:.6g} {:.6g}\n", point.size, point.error);
  return block + "END_OF_DATA\n";
}

/// The fitted line between its ends; empty where there is none.
std::vector<LevelPoint> fitted_line(const ConvergenceStudy& study) {
  const double at_coarsest = study.finding.fit.error_at(study.sizes.front());
  if (study.finding.verdict != exchange::Convergence::converging || !std::isfinite(at_coarsest)) return {};
  return {{study.sizes.front(), at_coarsest}, {study.sizes.back(), study.finding.fit.error_at(study.sizes.back())}};
}

/// A part of the axis of sizes: 0 at the finest level, 1 at the coarsest.
struct Share {
  double from = 0, to = 1;
};

/// The part that the i-th of n triangles takes: no two meet, and each has room for its order at the right.
Share share_of_triangle(std::size_t i, std::size_t n) {
  if (n == 1) return {.from = 0.5, .to = 0.8};
  const double each = 1.0 / static_cast<double>(n);
  const double from = (static_cast<double>(i) + 0.2) * each;
  return {.from = from, .to = from + 0.5 * each};
}

/// A triangle of the expected slope below the fitted line: its legs are one unit along and `order` units up.
std::string slope_triangle(const ConvergenceStudy& study, const Share& share) {
  const double order = *study.expected.order;
  const double span = std::log(study.sizes.front() / study.sizes.back());
  const double left = study.sizes.back() * std::exp(share.from * span);
  const double right = study.sizes.back() * std::exp(share.to * span);
  const double low = 0.45 * study.finding.fit.error_at(left);
  const double high = low * std::pow(right / left, order);
  const std::string line = "nohead front lw 1.1 lc rgb '#444444'";
  return fmt::format("set arrow from {0:.6g}, {2:.6g} to {1:.6g}, {2:.6g} {4}\n"
                     "set arrow from {1:.6g}, {2:.6g} to {1:.6g}, {3:.6g} {4}\n"
                     "set arrow from {0:.6g}, {2:.6g} to {1:.6g}, {3:.6g} {4}\n"
                     "set label '1' at {5:.6g}, {2:.6g} center offset 0,-0.7 tc rgb '#444444' front\n"
                     "set label '{6:.3g}' at {1:.6g}, {7:.6g} left offset 0.5,0 tc rgb '#444444' front\n",
                     left, right, low, high, line, std::sqrt(left * right), order, std::sqrt(low * high));
}

/// One triangle for each order that is expected and observed.
std::string slope_triangles(const ConvergencePlot& plot) {
  std::vector<const ConvergenceStudy*> drawn;
  for (const ConvergenceStudy* study : plot.studies) {
    if (!study->expected.order || fitted_line(*study).empty()) continue;
    const bool known = std::any_of(drawn.begin(), drawn.end(), [&](const ConvergenceStudy* other) {
      return *other->expected.order == *study->expected.order;
    });
    if (!known) drawn.push_back(study);
  }
  std::string text;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    text += slope_triangle(*drawn[i], share_of_triangle(i, drawn.size()));
  return text;
}

/// The ends of an axis.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;

  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// Powers of ten, with their double and fivefold on an axis of two decades or less.
std::string decade_tics(const Extent& extent) {
  const bool short_axis = extent.high < 100.0 * extent.low;
  std::vector<std::string> tics;
  for (int decade = static_cast<int>(std::floor(std::log10(extent.low))); std::pow(10.0, decade) < extent.high;
       ++decade) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double tic = factor * std::pow(10.0, decade);
      if (extent.low <= tic && tic <= extent.high && (factor == 1.0 || short_axis))
        tics.push_back(fmt::format("'{0:.0e}' {0:.6g}", tic));
    }
  }
  return fmt::format("{}", fmt::join(tics, ", "));
}

std::string size_tics(const ConvergencePlot& plot) {
  std::set<double> sizes;
  for (const ConvergenceStudy* study : plot.studies)
    sizes.insert(study->sizes.begin(), study->sizes.end());
  std::vector<std::string> tics;
  for (const double size : sizes)
    tics.push_back(fmt::format("'{0:.6g}' {0:.6g}", size));
  return fmt::format("{}", fmt::join(tics, ", "));
}

std::string axes(const ConvergencePlot& plot) {
  Extent sizes;
  Extent errors;
  for (const ConvergenceStudy* study : plot.studies) {
    for (const LevelPoint& point : drawable(*study)) {
      sizes.include(point.size);
      errors.include(point.error);
    }
    sizes.include(study->sizes.front());
    sizes.include(study->sizes.back());
  }
  errors = {.low = 0.4 * errors.low, .high = 1.8 * errors.high}; // room for a triangle below the points
  return fmt::format("set border 3 lw 1 lc rgb '#555555'\n"
                     "set tics nomirror out scale 0.6\n"
                     "set grid xtics ytics lt 1 lw 0.8 lc rgb '#E4E4E4'\n"
                     "set logscale xy\n"
                     "set xlabel {} offset 0,0.2\n"
                     "set ylabel 'Relative error of {} [-]' offset 1.2,0\n"
                     "set xtics ({})\n"
                     "set ytics ({})\n"
                     "set xrange [{:.6g}:{:.6g}]\n"
                     "set yrange [{:.6g}:{:.6g}]\n",
                     gnuplot_text(size_title(plot.size)), exchange::name_of(plot.quantity), size_tics(plot),
                     decade_tics(errors), 0.8 * sizes.low, 1.25 * sizes.high, errors.low, errors.high);
}

} // namespace

std::vector<ConvergencePlot> convergence_plots(const Family& family, std::vector<std::string>& missing) {
  std::vector<ConvergencePlot> plots;
  for (const ConvergenceStudy& study : family.studies) {
    if (!study.problem.empty() || drawable(study).empty()) {
      missing.push_back(
          fmt::format("{}: {}", study.title(), study.problem.empty() ? "no error above zero" : study.problem));
      continue;
    }
    const auto same = [&](const ConvergencePlot& plot) { return plot.quantity == study.expected.quantity; };
    auto plot = std::find_if(plots.begin(), plots.end(), same);
    if (plot == plots.end())
      plot = plots.insert(plots.end(), {.quantity = study.expected.quantity, .size = family.size, .studies = {}});
    plot->studies.push_back(&study);
  }
  return plots;
}

std::string gnuplot_script(const ConvergencePlot& plot) {
  std::string script;
  std::vector<std::string> curves;
  std::size_t key_rows = 0;
  for (std::size_t i = 0; i < plot.studies.size(); ++i) {
    const ConvergenceStudy& study = *plot.studies[i];
    const CurveStyle style = style_of_study(plot, i);
    const std::vector<LevelPoint> line = fitted_line(study);
    const KeyText key = key_text(label_of(study));
    key_rows += key.rows;
    script += data_block(fmt::format("levels{}", i), drawable(study));
    curves.push_back(fmt::format("$levels{} using 1:2 with {} pt {} ps {} lw 1 dt 3 lc rgb '{}' {}", i,
                                 line.empty() ? "linespoints" : "points", style.point_type, style.point_size,
                                 style.colour, key.title));
    if (line.empty()) continue;
    script += data_block(fmt::format("line{}", i), line);
    curves.push_back(fmt::format("$line{} using 1:2 with lines lw 1.2 lc rgb '{}' notitle", i, style.colour));
  }
  return gnuplot_canvas(key_rows, wide_left_margin) + axes(plot) + slope_triangles(plot) + script +
         fmt::format("plot {}\n", fmt::join(curves, ", \\\n  "));
}

} // namespace settle::compare::report
