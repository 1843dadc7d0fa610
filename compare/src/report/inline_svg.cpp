#include <algorithm>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include <pugixml.hpp>

#include "format.hpp"
#include "gnuplot.hpp"
#include "settle/exchange/errors.hpp"
#include "svg_shapes.hpp"

namespace settle::compare::report {

namespace {

using pugi::xml_attribute;
using pugi::xml_node;

template <class Visit>
void for_each_element(xml_node node, const Visit& visit) {
  for (xml_node child = node.first_child(); child;) {
    const xml_node next = child.next_sibling(); // `visit` may remove the child
    for_each_element(child, visit);
    if (child.type() == pugi::node_element) visit(child);
    child = next;
  }
}

void remove_children(xml_node node, const char* name) {
  while (node.child(name))
    node.remove_child(name);
}

/// gnuplot opens a group for every pen it picks up: most draw nothing.
void remove_empty_groups(xml_node svg) {
  for_each_element(svg, [](xml_node element) {
    if (std::string_view(element.name()) == "g" && !element.first_child()) element.parent().remove_child(element);
  });
}

/// Definitions (markers, filters) that nothing refers to, until none is left.
void remove_unused_definitions(xml_node svg) {
  xml_node definitions = svg.first_element_by_path("g/defs");
  for (bool removed = true; removed;) {
    removed = false;
    std::set<std::string> used;
    for_each_element(svg, [&](xml_node element) {
      const std::string target = element.attribute("xlink:href").value();
      if (!target.empty()) used.insert(target.substr(1));
    });
    for (xml_node entry = definitions.first_child(); entry;) {
      const xml_node next = entry.next_sibling();
      if (used.count(entry.attribute("id").value()) == 0) removed |= definitions.remove_child(entry);
      entry = next;
    }
  }
}

void prefix_ids(xml_node svg, const std::string& prefix) {
  for_each_element(svg, [&](xml_node element) {
    if (xml_attribute id = element.attribute("id")) id.set_value((prefix + "-" + id.value()).c_str());
    if (xml_attribute target = element.attribute("xlink:href")) {
      target.set_value(("#" + prefix + "-" + (target.value() + 1)).c_str());
    }
  });
}

/// Coordinates need no trailing zeros, colours no blanks.
std::string compact(std::string text) {
  for (std::size_t at = 0; (at = text.find(".00", at)) != std::string::npos;) {
    const std::size_t after = at + 3;
    const bool ends = after == text.size() || std::string_view(" ,)").find(text[after]) != std::string_view::npos;
    if (ends)
      text.erase(at, 3);
    else
      at = after;
  }
  std::string result;
  std::unique_copy(text.begin(), text.end(), std::back_inserter(result),
                   [](char a, char b) { return a == ' ' && b == ' '; });
  return result;
}

void compact_attributes(xml_node svg) {
  for_each_element(svg, [](xml_node element) {
    element.remove_attribute("font-family"); // the page's own
    for (xml_attribute attribute : element.attributes()) {
      const std::string_view name = attribute.name();
      if (name == "d" || name == "transform" || name == "color" || name == "stroke") {
        attribute.set_value(compact(attribute.value()).c_str());
      }
    }
  });
}

/// Markers of one curve share their colour: said once, by the group.
void share_colours(xml_node svg) {
  for_each_element(svg, [](xml_node group) {
    const xml_node first = group.child("use");
    const std::string colour = first.attribute("color").value();
    if (std::string_view(group.name()) != "g" || colour.empty()) return;
    for (xml_node use : group.children("use")) {
      if (use.attribute("color").value() != colour) return;
    }
    for (xml_node use : group.children("use"))
      use.remove_attribute("color");
    xml_attribute shared = group.attribute("color");
    (shared ? shared : group.append_attribute("color")).set_value(colour.c_str());
  });
}

void set_accessible_name(xml_node svg, const std::string& prefix, const std::string& title) {
  const std::string id = prefix + "-title";
  svg.append_attribute("role").set_value("img");
  svg.append_attribute("aria-labelledby").set_value(id.c_str());
  svg.append_attribute("font-family").set_value("system-ui, sans-serif");
  xml_node name = svg.prepend_child("title");
  name.append_attribute("id").set_value(id.c_str());
  name.text().set(printable(title).c_str());
}

} // namespace

std::string inline_svg(const std::string& svg, const std::string& prefix, const std::string& title) {
  pugi::xml_document document;
  const pugi::xml_parse_result parsed = document.load_string(svg.c_str());
  xml_node root = document.child("svg");
  if (!parsed || !root) {
    throw exchange::FileError({.where = "gnuplot",
                               .what = "what it drew cannot be read as SVG",
                               .given = parsed.description(),
                               .allowed = "",
                               .remedy = "check the installation with `gnuplot --version` (5.4 or later is needed)"});
  }
  if (const auto written = short_svg(root, printable(title))) return *written;
  remove_children(root, "title");
  remove_children(root, "desc");
  for_each_element(root, [](xml_node element) { remove_children(element, "title"); });
  remove_empty_groups(root);
  remove_unused_definitions(root);
  compact_attributes(root);
  share_colours(root);
  prefix_ids(root, prefix);
  set_accessible_name(root, prefix, title);
  std::ostringstream text;
  root.print(text, "", pugi::format_raw | pugi::format_no_declaration);
  return text.str();
}

} // namespace settle::compare::report
