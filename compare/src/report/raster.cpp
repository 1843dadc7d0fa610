#include "raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace settle::compare::report {

using exchange::PlaneBox;
using exchange::PlanePoint;

namespace {

/// Twice the area of the triangle a, b, c: positive where it runs anticlockwise.
double turn(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool inside(const std::array<PlanePoint, 4>& corners, const PlanePoint& point) {
  bool left = true, right = true;
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = turn(corners[i], corners[(i + 1) % 4], point);
    left = left && side >= 0.0;
    right = right && side <= 0.0;
  }
  return left || right;
}

PlaneBox box_of(const std::array<PlanePoint, 4>& corners) {
  PlaneBox box{.lowest = corners[0], .highest = corners[0]};
  for (const PlanePoint& corner : corners) {
    for (std::size_t d = 0; d < 2; ++d) {
      box.lowest[d] = std::min(box.lowest[d], corner[d]);
      box.highest[d] = std::max(box.highest[d], corner[d]);
    }
  }
  return box;
}

int pixels_along(double length, double pixel) {
  return std::max(1, static_cast<int>(std::ceil(length / pixel - 1e-9)));
}

} // namespace

Raster::Raster(const PlaneBox& box, const PlanePoint& pixel)
    : box_(box), pixel_(pixel), width_(pixels_along(box.highest[0] - box.lowest[0], pixel[0])),
      height_(pixels_along(box.highest[1] - box.lowest[1], pixel[1])),
      pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), background),
      distance_(pixels_.size(), std::numeric_limits<double>::infinity()) {}

PlanePoint Raster::middle(int column, int row) const {
  return {box_.lowest[0] + (column + 0.5) * pixel_[0], box_.highest[1] - (row + 0.5) * pixel_[1]};
}

template <class Draw>
void Raster::for_each_in(const PlaneBox& box, const Draw& draw) {
  // The first pixel whose middle is not before a place; clamped before it becomes an integer.
  const auto first = [&](double place, std::size_t axis, int count) {
    return static_cast<int>(std::clamp(std::ceil(place / pixel_[axis] - 0.5), 0.0, static_cast<double>(count)));
  };
  const int left = first(box.lowest[0] - box_.lowest[0], 0, width_);
  const int right = first(box.highest[0] - box_.lowest[0] + pixel_[0], 0, width_);
  const int top = first(box_.highest[1] - box.highest[1], 1, height_);
  const int bottom = first(box_.highest[1] - box.lowest[1] + pixel_[1], 1, height_);
  for (int row = top; row < bottom; ++row) {
    for (int column = left; column < right; ++column)
      draw(column, row, middle(column, row));
  }
}

void Raster::fill(const std::array<PlanePoint, 4>& corners, std::uint8_t entry) {
  for_each_in(box_of(corners), [&](int column, int row, const PlanePoint& point) {
    if (inside(corners, point)) pixels_[index(column, row)] = entry;
  });
}

void Raster::stamp(const PlanePoint& point, double radius, std::uint8_t entry) {
  const PlaneBox around{.lowest = {point[0] - radius, point[1] - radius},
                        .highest = {point[0] + radius, point[1] + radius}};
  for_each_in(around, [&](int column, int row, const PlanePoint& here) {
    const double distance = std::hypot(here[0] - point[0], here[1] - point[1]);
    double& nearest = distance_[index(column, row)];
    if (distance > radius || distance >= nearest) return;
    nearest = distance;
    pixels_[index(column, row)] = entry;
  });
}

} // namespace settle::compare::report
