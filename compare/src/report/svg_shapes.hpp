/// \file
/// gnuplot's SVG taken apart into what is seen, and written anew in a fraction of its length.
#pragma once

#include <optional>
#include <string>

#include <pugixml.hpp>

namespace settle::compare::report {

/// The drawing with lines, markers and texts of one look gathered, coordinates to a tenth of a pixel, and points left
/// out that lie nearer than that to their line. Nothing where it holds an element that is not known here.
/// `title`: its accessible name.
std::optional<std::string> short_svg(pugi::xml_node svg, const std::string& title);

} // namespace settle::compare::report
