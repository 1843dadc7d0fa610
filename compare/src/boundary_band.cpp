#include "boundary_band.hpp"

#include <algorithm>

namespace settle::compare {
namespace {

Box box_around(const BoundarySide& side) {
  Box box{side[0], side[0]};
  for (const exchange::SolidPoint& corner : side)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.lowest[axis] = std::min(box.lowest[axis], corner[axis]);
      box.highest[axis] = std::max(box.highest[axis], corner[axis]);
    }
  return box;
}

} // namespace

BoundaryBand BoundaryBand::along_free_surface(const exchange::Case& study, int stage, double width) {
  if (study.geometry.varies_along_y()) return {{}, free_sides(study, stage), width};
  return {free_surface(study, stage), {}, width};
}

BoundaryBand BoundaryBand::along_base(const exchange::Case& study, double width) {
  if (study.geometry.varies_along_y()) return {{}, base_sides(study), width};
  return {base(study), {}, width};
}

BoundaryBand::BoundaryBand(std::vector<BoundaryPart> lines, std::vector<BoundarySide> sides, double width)
    : lines_(std::move(lines)), sides_(std::move(sides)), width_(width) {
  std::vector<Box> boxes;
  for (const BoundarySide& side : sides_)
    boxes.push_back(box_around(side));
  if (!boxes.empty()) bins_.emplace(boxes);
}

bool BoundaryBand::holds(const exchange::SolidPoint& point) const {
  if (!bins_) return distance(lines_, {point[0], point[2]}) <= width_;
  Box near{point, point};
  for (std::size_t axis = 0; axis < 3; ++axis)
    near.lowest[axis] -= width_, near.highest[axis] += width_;
  const std::vector<std::size_t> numbers = bins_->near(near);
  return std::any_of(numbers.begin(), numbers.end(),
                     [&](std::size_t number) { return distance(sides_[number], point) <= width_; });
}

} // namespace settle::compare
