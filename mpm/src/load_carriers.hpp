/// \file
/// Points that carry loads on the surface: those of a cell together.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "settle/mpm/body.hpp"
#include "settle/mpm/scattered_sampling.hpp"

namespace settle::mpm {

/// The cell of each point; of a section that is extruded, one for all cells side by side along y, which carry what is
/// on the section alike.
template <class Space>
std::vector<int> cells_of_carriers(const exchange::Case& study, const Body<Space>& body);

/// What a place of the surface rests on: the points in the cell of the one that is nearest to it, so that an even load
/// on the whole side of a cell comes to its nodes as it should.
class LoadCarriers {
public:
  /// `cells`: of all points, of which those scattered are some; `size`: about that of a cell [m].
  LoadCarriers(Scattered points, const std::vector<int>& cells, double size);

  /// There is one point at least.
  [[nodiscard]] const Scattered& near(const Place& place) const;

private:
  using Bin = std::array<int, 3>;

  Scattered points_;
  double size_;
  std::vector<int> cells_; ///< of each of the points
  std::map<int, Scattered> by_cell_;
  std::map<Bin, std::vector<std::size_t>> bins_; ///< places among the points

  [[nodiscard]] Bin bin_of(const Place& place) const;
  [[nodiscard]] std::size_t nearest(const Place& place) const;
};

} // namespace settle::mpm
