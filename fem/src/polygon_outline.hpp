/// \file
/// Corners and edges that the polygons of a case have in common, and into how many parts each edge is divided.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::fem {

/// What an outline's polygon knows of its corners.
using CornerNumbers = std::vector<unsigned>;

class PolygonOutline {
public:
  /// Throws InputError for polygons of more than four corners, and where edges are shared in part only.
  explicit PolygonOutline(const exchange::Case& study);

  /// Each corner once, whatever the number of polygons it belongs to [m].
  [[nodiscard]] const std::vector<exchange::PlanePoint>& corners() const { return corners_; }
  /// For each polygon its corners, anticlockwise.
  [[nodiscard]] const std::vector<CornerNumbers>& polygons() const { return polygons_; }
  /// Parts of the edge between two corners that are neighbours in a polygon.
  [[nodiscard]] unsigned parts(unsigned from, unsigned to) const;

private:
  using Edge = std::pair<unsigned, unsigned>; ///< numbers of its corners, ascending

  unsigned number_of(const exchange::PlanePoint& corner);
  void collect(const exchange::Geometry& geometry);
  void require_whole_edges(const exchange::Case& study) const;
  void count_parts(const exchange::Case& study);
  std::size_t group_of(const Edge& edge);
  void divide_alike(const Edge& one, const Edge& other);
  [[nodiscard]] double length(const Edge& edge) const;

  double slack_; ///< distance that is round-off [m]
  std::vector<exchange::PlanePoint> corners_;
  std::vector<CornerNumbers> polygons_;
  std::map<Edge, std::size_t> groups_; ///< of edges divided alike
  std::vector<std::size_t> joined_to_; ///< each group: the one it became part of, or itself
  std::vector<unsigned> parts_;        ///< of each group
};

} // namespace settle::fem
