#include "loaded_parts.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "settle/exchange/loaded_surface.hpp"
#include "settle/exchange/valley.hpp"

namespace settle::mpm {
namespace {

constexpr double parts_per_spacing = 4.0;

int parts_of(double length, double spacing) {
  return std::max(1, static_cast<int>(std::ceil(parts_per_spacing * length / spacing)));
}

Vector<3> on_section(const std::vector<double>& vector) {
  return {vector[0], 0.0, vector[1]};
}

/// Across the valley, at the middle of a part of the section's line of this length.
void add_across(const exchange::Valley& valley, const Place& middle, const Vector<3>& force_per_width, double spacing,
                std::vector<LoadedPart>& parts) {
  const exchange::Span span = exchange::valley_at(valley, middle[2]);
  const int count = parts_of(span.width(), spacing);
  for (int i = 0; i < count; ++i)
    parts.push_back(
        {{middle[0], span.from + (i + 0.5) / count * span.width(), middle[2]}, span.width() / count * force_per_width});
}

std::vector<LoadedPart> parts_of_line(const exchange::Case& study, const exchange::StageEntry& load, double spacing) {
  const exchange::Geometry& geometry = study.geometry;
  const Vector<3> from = on_section(load.from), to = on_section(load.to);
  const double length = (to - from).norm();
  const int count = parts_of(length, spacing);
  const Vector<3> force = length / count * on_section(load.traction); // per depth
  std::vector<LoadedPart> parts;
  for (int i = 0; i < count; ++i) {
    const Place middle = from + (i + 0.5) / count * (to - from);
    if (geometry.valley)
      add_across(*geometry.valley, middle, force, spacing, parts);
    else
      parts.push_back({middle, geometry.dimension == 2 ? force : Vector<3>(*geometry.depth * force)});
  }
  return parts;
}

/// A side of a hexahedron, bilinear between its corners a, b, c, d.
void add_side(const std::array<Vector<3>, 4>& corners, const Vector<3>& traction, double spacing,
              std::vector<LoadedPart>& parts) {
  const auto& [a, b, c, d] = corners;
  const int along = parts_of(std::max((b - a).norm(), (c - d).norm()), spacing);
  const int across = parts_of(std::max((d - a).norm(), (c - b).norm()), spacing);
  const Vector<3> twist = c - d - b + a;
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = (i + 0.5) / along, v = (j + 0.5) / across;
      const double area = (b - a + v * twist).cross(d - a + u * twist).norm() / (along * across);
      parts.push_back({a + u * (b - a) + v * (d - a) + u * v * twist, area * traction});
    }
}

std::vector<LoadedPart> parts_of_sides(const exchange::Mesh& mesh, const exchange::StageEntry& load,
                                       const std::set<int>& present, double spacing) {
  const Vector<3> traction(load.traction[0], load.traction[1], load.traction[2]);
  std::vector<LoadedPart> parts;
  for (const exchange::FreeSide& side : exchange::sides_in_box(mesh, load, present).whole) {
    std::array<Vector<3>, 4> corners;
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const auto& [x, y, z] = mesh.nodes[side.nodes[c]];
      corners[c] = {x, y, z};
    }
    add_side(corners, traction, spacing, parts);
  }
  return parts;
}

} // namespace

std::vector<LoadedPart> loaded_parts(const exchange::Case& study, const exchange::StageEntry& load,
                                     const std::set<int>& present, double spacing) {
  if (study.geometry.solid_mesh()) return parts_of_sides(*study.geometry.mesh, load, present, spacing);
  return parts_of_line(study, load, spacing);
}

} // namespace settle::mpm
