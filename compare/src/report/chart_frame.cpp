#include "chart_frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "format.hpp"
#include "svg_path.hpp"

namespace settle::compare::report {

namespace {

constexpr double tic = 4.0;               // pixels
constexpr double pixels_of_label = 100.0; // room that a label along a horizontal axis takes
constexpr double pixels_of_row = 100.0;

int most_labels(const ChartAxis& axis, double room) {
  return std::max(2, static_cast<int>(std::abs(axis.to - axis.from) / room) + 1);
}

/// Along one of the axes.
std::string line(double x1, double y1, double x2, double y2) {
  const bool is_horizontal = y1 == y2;
  return fmt::format("M{} {}{}{}", short_coordinate(x1), short_coordinate(y1), is_horizontal ? 'H' : 'V',
                     short_coordinate(is_horizontal ? x2 : y2));
}

std::string path(const std::string& lines) {
  return fmt::format(R"(<path class="axis" d="{}"/>)", lines);
}

std::string text(double x, double y, const std::string& content) {
  return fmt::format(R"(<text x={} y={}>{}</text>)", short_coordinate(x), short_coordinate(y), escaped(content));
}

std::string anchored(const char* anchor, const std::string& texts) {
  return fmt::format(R"(<g class={}>{}</g>)", anchor, texts);
}

/// A multiple of three, by which values that are tiny or huge are written; 0 for those that are neither.
int power_of(double largest) {
  if (largest == 0.0 || (largest >= 0.01 && largest < 1e5)) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0));
}

std::string superscript(int number) {
  static const std::array<const char*, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = number < 0 ? "⁻" : "";
  for (const char digit : fmt::format("{}", std::abs(number)))
    text += digits[static_cast<std::size_t>(digit - '0')];
  return text;
}

std::string vertical_axis(const ChartAxis& axis, double x) {
  const AxisText all = axis_text(axis, most_labels(axis, pixels_of_row));
  std::string lines = line(x, axis.from, x, axis.to), labels;
  for (std::size_t i = 0; i < all.values.size(); ++i) {
    const double y = axis.pixel(all.values[i]);
    lines += line(x - tic, y, x, y);
    labels += text(x - tic - 3.0, y + 4.0, all.labels[i]);
  }
  const double middle = 0.5 * (axis.from + axis.to);
  return path(lines) + anchored("end", labels) +
         fmt::format(R"svg(<text transform="translate(12 {}) rotate(-90)" class=middle>{}</text>)svg",
                     short_coordinate(middle), escaped(all.title));
}

} // namespace

std::vector<double> round_values(double lowest, double highest, int most) {
  const double span = highest - lowest;
  std::vector<double> values;
  if (!(span > 0.0) || !std::isfinite(span)) return {lowest};
  for (double power = std::pow(10.0, std::floor(std::log10(span)) - 2.0); values.empty(); power *= 10.0) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double step = factor * power;
      const double first = std::ceil(lowest / step - 1e-9), last = std::floor(highest / step + 1e-9);
      if (last - first + 1.0 > most) continue;
      for (double k = first; k <= last; k += 1.0)
        values.push_back(k * step);
      if (values.empty()) return {lowest}; // no round value lies between the ends
      return values;
    }
  }
  return values;
}

AxisText axis_text(const ChartAxis& axis, int most) {
  AxisText text{.title = axis.title, .values = round_values(axis.lowest, axis.highest, most), .labels = {}};
  const int power = power_of(std::max(std::abs(axis.lowest), std::abs(axis.highest)));
  if (!axis.unit.empty())
    text.title += fmt::format(" [{}{}]", power == 0 ? "" : "10" + superscript(power) + " ", axis.unit);
  const double step = text.values.size() > 1 ? text.values[1] - text.values[0] : std::abs(text.values[0]);
  const double scale = std::pow(10.0, -power);
  const int decimals = step > 0.0 ? std::max(0, static_cast<int>(std::ceil(-std::log10(step * scale) - 1e-9))) : 0;
  for (const double value : text.values) {
    const std::string digits = fmt::format("{:.{}f}", std::abs(value * scale), decimals);
    const bool is_zero = digits.find_first_not_of("0.") == std::string::npos;
    text.labels.push_back((value < 0.0 && !is_zero ? "−" : "") + digits);
  }
  return text;
}

std::string axis_svg(const ChartAxis& x, double y) {
  const AxisText all = axis_text(x, most_labels(x, pixels_of_label));
  std::string lines = line(x.from, y, x.to, y), labels;
  for (std::size_t i = 0; i < all.values.size(); ++i) {
    const double at = x.pixel(all.values[i]);
    lines += line(at, y, at, y + tic);
    labels += text(at, y + tic + 14.0, all.labels[i]);
  }
  return path(lines) + anchored("middle", labels + text(0.5 * (x.from + x.to), y + tic + 35.0, all.title));
}

std::string axes_svg(const ChartAxis& x, const ChartAxis& y) {
  return axis_svg(x, y.from) + vertical_axis(y, x.from);
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : printable(text)) {
    switch (c) {
    case '&':
      safe += "&amp;";
      break;
    case '<':
      safe += "&lt;";
      break;
    case '>':
      safe += "&gt;";
      break;
    case '"':
      safe += "&quot;";
      break;
    default:
      safe += c;
    }
  }
  return safe;
}

} // namespace settle::compare::report
