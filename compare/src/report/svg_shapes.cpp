#include "svg_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "svg_path.hpp"

namespace settle::compare::report {

namespace {

using pugi::xml_node;

/// What is seen of one look: lines, or texts.
struct Shape {
  std::string look; ///< attributes of what is written
  std::vector<SvgLine> lines;
  std::string texts; ///< elements; empty for lines
};

/// What an element hands on to what is in it.
using Inherited = std::map<std::string, std::string>;

/// "rgb( 85, 85, 85)" as "#555".
std::string short_colour(const std::string& colour) {
  unsigned red = 0, green = 0, blue = 0;
  if (colour == "black") return "#000";
  if (std::sscanf(colour.c_str(), "rgb(%u,%u,%u)", &red, &green, &blue) != 3) return colour;
  const bool shorter = red % 17 == 0 && green % 17 == 0 && blue % 17 == 0;
  return shorter ? fmt::format("#{:x}{:x}{:x}", red / 17, green / 17, blue / 17)
                 : fmt::format("#{:02x}{:02x}{:02x}", red, green, blue);
}

/// A number without zeros at its end.
std::string short_number(double value) {
  return fmt::format("{:.4g}", value);
}

/// A marker: what a point looks like, about its own origin.
struct Glyph {
  std::vector<SvgLine> lines{}; ///< none: a circle of radius 1
  bool filled = false;
  double stroke = 0; ///< width of its line
};

void rotate(Glyph& glyph, double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180.0;
  for (SvgLine& line : glyph.lines) {
    for (SvgPoint& point : line.points)
      point = {std::cos(angle) * point.x - std::sin(angle) * point.y,
               std::sin(angle) * point.x + std::cos(angle) * point.y};
  }
}

/// Taking a drawing apart.
class Dismantling {
public:
  explicit Dismantling(xml_node svg) : definitions_(svg.first_element_by_path("g/defs")) {
    understood_ = true;
    visit_children(svg, {{"color", "black"}, {"stroke-width", "1"}, {"font-size", "15"}});
  }
  [[nodiscard]] bool understood() const { return understood_; }
  [[nodiscard]] const std::vector<Shape>& shapes() const { return shapes_; }

private:
  void visit_children(xml_node node, const Inherited& inherited) {
    for (const xml_node child : node.children()) {
      if (child.type() == pugi::node_element) visit(child, inherited);
    }
  }

  void visit(xml_node element, Inherited inherited) {
    for (const pugi::xml_attribute attribute : element.attributes())
      inherited[attribute.name()] = attribute.value();
    const std::string_view name = element.name();
    if (name == "g") {
      const bool is_plot = std::string_view(element.attribute("id").value()).find("gnuplot_plot") == 0;
      if (is_plot) fixed_ = shapes_.size(); // curves stay in their order, and above axes
      visit_children(element, inherited);
      if (is_plot) fixed_ = shapes_.size();
    } else if (name == "path") {
      add_lines(inherited);
    } else if (name == "use") {
      add_marker(inherited);
    } else if (name == "text") {
      add_text(element, inherited);
    } else if (name == "rect") {
      understood_ &= inherited["fill"] == "none"; // the canvas
    } else if (name != "defs" && name != "title" && name != "desc") {
      understood_ = false;
    }
  }

  Shape& shape_like(const std::string& look, bool is_text) {
    const auto from = shapes_.begin() + static_cast<std::ptrdiff_t>(fixed_);
    const auto same = std::find_if(
        from, shapes_.end(), [&](const Shape& shape) { return shape.look == look && shape.texts.empty() != is_text; });
    if (same != shapes_.end()) return *same;
    shapes_.push_back({.look = look, .lines = {}, .texts = {}});
    return shapes_.back();
  }

  void add_lines(Inherited& from) {
    const auto lines = parse_path(from["d"]);
    const bool filled = from["fill"] != "none" && !from["fill"].empty();
    understood_ &= lines.has_value() && !filled;
    if (!lines) return;
    const std::string stroke = from["stroke"] == "currentColor" ? from["color"] : from["stroke"];
    std::string look = fmt::format("stroke=\"{}\"", short_colour(stroke));
    const double width = std::atof(from["stroke-width"].c_str());
    if (width != 1.0) look += fmt::format(" stroke-width=\"{}\"", short_number(width));
    if (!from["stroke-dasharray"].empty()) look += fmt::format(" stroke-dasharray=\"{}\"", from["stroke-dasharray"]);
    Shape& shape = shape_like(look, false);
    constexpr double tolerance = 0.1;
    for (const SvgLine& line : *lines)
      shape.lines.push_back(simplified(line, tolerance));
  }

  void add_text(xml_node element, Inherited& from) {
    double x = 0, y = 0, angle = 0;
    const bool placed = std::sscanf(from["transform"].c_str(), "translate(%lf,%lf) rotate(%lf", &x, &y, &angle) >= 2;
    understood_ &= placed && !element.first_element_by_path("tspan");
    std::string look = fmt::format("fill=\"{}\"", short_colour(from["fill"]));
    if (from["text-anchor"] == "middle" || from["text-anchor"] == "end")
      look += fmt::format(" text-anchor=\"{}\"", from["text-anchor"]);
    const double size = std::atof(from["font-size"].c_str());
    if (size != 15.0) look += fmt::format(" font-size=\"{}\"", short_number(size));
    xml_node copy = texts_.append_child("text");
    if (angle == 0.0) {
      copy.append_attribute("x").set_value(short_coordinate(x).c_str());
      copy.append_attribute("y").set_value(short_coordinate(y).c_str());
    } else {
      copy.append_attribute("transform")
          .set_value(
              fmt::format("translate({} {})rotate({})", short_coordinate(x), short_coordinate(y), angle).c_str());
    }
    const std::string_view text = element.text().get();
    copy.text().set(std::string(text.substr(std::min(text.find_first_not_of(' '), text.size()))).c_str());
    std::ostringstream written;
    copy.print(written, "", pugi::format_raw);
    shape_like(look, true).texts += written.str();
  }

  Glyph glyph_of(const std::string& reference) {
    const xml_node definition = definitions_.find_child_by_attribute(
        "id", reference.substr(std::min<std::size_t>(1, reference.size())).c_str());
    const std::string_view name = definition.name();
    Glyph glyph{.stroke = definition.attribute("stroke-width").as_double()};
    if (name == "use") {
      glyph = glyph_of(definition.attribute("xlink:href").value());
      double angle = 0;
      if (std::sscanf(definition.attribute("transform").value(), "rotate(%lf", &angle) == 1) rotate(glyph, angle);
    } else if (name == "path") {
      glyph.lines = parse_path(definition.attribute("d").value()).value_or(std::vector<SvgLine>());
      understood_ &= !glyph.lines.empty();
    } else if (name == "rect") {
      glyph.lines = {{.points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, .closed = true}};
    } else if (name != "circle") {
      understood_ = false;
    }
    glyph.filled |= std::string_view(definition.attribute("fill").value()) == "currentColor";
    return glyph;
  }

  void add_marker(Inherited& from) {
    double x = 0, y = 0, scale = 0;
    understood_ &= std::sscanf(from["transform"].c_str(), "translate(%lf,%lf) scale(%lf", &x, &y, &scale) == 3;
    const auto [known, is_new] = glyphs_.try_emplace(from["xlink:href"]);
    if (is_new) known->second = glyph_of(from["xlink:href"]);
    const Glyph& glyph = known->second;
    const std::string colour = short_colour(from["color"]);
    if (glyph.lines.empty()) return add_circle(glyph, {x, y}, scale, colour);
    std::string look = glyph.filled ? fmt::format("fill=\"{}\"", colour) : fmt::format("stroke=\"{}\"", colour);
    if (!glyph.filled) look += fmt::format(" stroke-width=\"{}\"", short_number(glyph.stroke * scale));
    Shape& shape = shape_like(look, false);
    for (SvgLine line : glyph.lines) {
      for (SvgPoint& point : line.points)
        point = {x + scale * point.x, y + scale * point.y};
      shape.lines.push_back(std::move(line));
    }
  }

  /// A dot with round ends is a disc; the line of an open circle is one of many sides.
  void add_circle(const Glyph& glyph, const SvgPoint& centre, double radius, const std::string& colour) {
    if (glyph.filled) {
      shape_like(
          fmt::format("stroke=\"{}\" stroke-linecap=\"round\" stroke-width=\"{}\"", colour, short_number(2.0 * radius)),
          false)
          .lines.push_back({.points = {centre}});
      return;
    }
    constexpr int sides = 12;
    SvgLine line{.points = {}, .closed = true};
    for (int i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::acos(-1.0) * i / sides;
      line.points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    shape_like(fmt::format("stroke=\"{}\" stroke-width=\"{}\"", colour, short_number(glyph.stroke * radius)), false)
        .lines.push_back(std::move(line));
  }

  xml_node definitions_;
  pugi::xml_document texts_;
  std::map<std::string, Glyph> glyphs_;
  std::vector<Shape> shapes_;
  std::size_t fixed_ = 0; ///< shapes before this one are not added to any more
  bool understood_ = false;
};

std::string escaped(const std::string& text) {
  pugi::xml_document document;
  document.append_child("a").append_attribute("a").set_value(text.c_str());
  std::ostringstream written;
  document.print(written, "", pugi::format_raw | pugi::format_no_declaration);
  const std::string element = written.str(); // <a a="..."/>
  return element.substr(6, element.rfind('"') - 6);
}

} // namespace

std::optional<std::string> short_svg(xml_node svg, const std::string& title) {
  const Dismantling drawing(svg);
  if (!drawing.understood()) return {};
  std::string text = fmt::format("<svg class=\"plot\" viewBox=\"{}\" role=\"img\" aria-label=\"{}\" font-size=\"15\" "
                                 "fill=\"none\">",
                                 svg.attribute("viewBox").value(), escaped(title));
  for (const Shape& shape : drawing.shapes()) {
    text += shape.texts.empty() ? fmt::format("<path {} d=\"{}\"/>", shape.look, path_text(shape.lines))
                                : fmt::format("<g {}>{}</g>", shape.look, shape.texts);
  }
  return text + "</svg>";
}

} // namespace settle::compare::report
