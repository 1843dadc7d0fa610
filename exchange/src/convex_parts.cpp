#include "convex_parts.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "settle/exchange/mesh_sides.hpp"

namespace settle::exchange {

ConvexParts::ConvexParts(const Mesh& mesh) : mesh_(mesh), slack_(mesh_slack(mesh)) {}

double ConvexParts::area(const Corners& polygon) const {
  double doubled = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = mesh_.nodes[polygon[i]], &b = mesh_.nodes[polygon[(i + 1) % polygon.size()]];
    doubled += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * doubled;
}

/// How far the corner b is from the way from a to c: positive on its right, where a left turn has it [m].
double ConvexParts::turn(unsigned a, unsigned b, unsigned c) const {
  const auto &from = mesh_.nodes[a], &at = mesh_.nodes[b], &to = mesh_.nodes[c];
  const double ux = to[0] - from[0], uy = to[1] - from[1], vx = at[0] - from[0], vy = at[1] - from[1];
  return (uy * vx - ux * vy) / std::hypot(ux, uy);
}

bool ConvexParts::is_convex(const Corners& polygon) const {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    if (turn(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) < -slack_) return false;
  return true;
}

/// Can the triangle of a corner and its neighbours be cut off?
bool ConvexParts::is_ear(const Corners& polygon, std::size_t at) const {
  const std::size_t n = polygon.size();
  const unsigned a = polygon[(at + n - 1) % n], b = polygon[at], c = polygon[(at + 1) % n];
  if (turn(a, b, c) <= slack_) return false;
  return std::none_of(polygon.begin(), polygon.end(), [&](unsigned other) {
    if (other == a || other == b || other == c) return false;
    const double outside = std::max({turn(a, other, b), turn(b, other, c), turn(c, other, a)});
    return outside <= slack_;
  });
}

std::vector<ConvexParts::Corners> ConvexParts::triangles(Corners outline) const {
  std::vector<Corners> parts;
  while (outline.size() > 3) {
    std::size_t at = 0;
    while (at < outline.size() && !is_ear(outline, at))
      ++at;
    if (at == outline.size()) break; // only round-off is left
    const std::size_t n = outline.size();
    parts.push_back({outline[(at + n - 1) % n], outline[at], outline[(at + 1) % n]});
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(at));
  }
  if (outline.size() == 3 && turn(outline[0], outline[1], outline[2]) > slack_) parts.push_back(outline);
  return parts;
}

std::vector<ConvexParts::Corners> ConvexParts::of_outlines(const std::vector<Corners>& outlines) const {
  std::vector<Corners> parts;
  for (const Corners& outline : outlines) {
    const std::vector<Corners> own = is_convex(outline) ? std::vector<Corners>{outline} : merged(triangles(outline));
    parts.insert(parts.end(), own.begin(), own.end());
  }
  return parts;
}

/// Around both; nothing where they share no edge or are not convex together. What two convex polygons share is one
/// straight line.
std::optional<ConvexParts::Corners> ConvexParts::joined(const Corners& one, const Corners& other) const {
  const std::size_t n = one.size(), m = other.size();
  const auto shared_from = [&](std::size_t i) { // place in the other where the edge from here ends, there its start
    for (std::size_t j = 0; j < m; ++j)
      if (other[j] == one[(i + 1) % n] && other[(j + 1) % m] == one[i % n]) return true;
    return false;
  };
  std::size_t last = 0; // edge that is shared, the one after it is not
  while (last < n && !(shared_from(last) && !shared_from(last + 1)))
    ++last;
  if (last == n) return {};
  std::size_t first = last;
  while (shared_from(first + n - 1))
    first = (first + n - 1) % n;
  Corners around;
  for (std::size_t i = (last + 1) % n; i != first; i = (i + 1) % n)
    around.push_back(one[i]);
  const auto start = static_cast<std::size_t>(std::find(other.begin(), other.end(), one[first]) - other.begin());
  for (std::size_t j = start; other[j % m] != one[(last + 1) % n]; ++j)
    around.push_back(other[j % m]);
  if (!is_convex(around)) return {};
  return around;
}

ConvexParts::Corners ConvexParts::without_straight_corners(const Corners& polygon) const {
  const std::size_t n = polygon.size();
  Corners corners;
  for (std::size_t i = 0; i < n; ++i)
    if (turn(polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]) > slack_) corners.push_back(polygon[i]);
  return corners;
}

std::vector<ConvexParts::Corners> ConvexParts::merged(std::vector<Corners> parts) const {
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size();) {
      const auto both = joined(parts[i], parts[j]);
      if (!both) {
        ++j;
        continue;
      }
      parts[i] = *both;
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1; // a neighbour refused before may fit now
    }
  for (Corners& part : parts)
    part = without_straight_corners(part);
  return parts;
}

} // namespace settle::exchange
