/// \file
/// A picture of pixels: one byte each, an entry of a palette.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "colour_map.hpp"
#include "settle/exchange/plane_geometry.hpp"

namespace settle::compare::report {

/// A part of the plane and the pixels that show it, the first row at the top.
class Raster {
public:
  /// Entry 0 of the palette is what nothing is drawn on.
  static constexpr std::uint8_t background = 0;

  /// `pixel`: width and height of a pixel [m].
  Raster(const exchange::PlaneBox& box, const exchange::PlanePoint& pixel);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] std::uint8_t at(int column, int row) const { return pixels_[index(column, row)]; }
  [[nodiscard]] const std::vector<std::uint8_t>& pixels() const { return pixels_; }

  /// Pixels whose middle lies in the quadrilateral; corners run around it, [m].
  void fill(const std::array<exchange::PlanePoint, 4>& corners, std::uint8_t entry);
  /// Pixels whose middle is not further than `radius` from the point and nearer to it than to any other one that was
  /// stamped, [m].
  void stamp(const exchange::PlanePoint& point, double radius, std::uint8_t entry);

private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  }
  [[nodiscard]] exchange::PlanePoint middle(int column, int row) const;
  /// Calls `draw(column, row, middle)` for the pixels whose middles lie in a box.
  template <class Draw>
  void for_each_in(const exchange::PlaneBox& box, const Draw& draw);

  exchange::PlaneBox box_;
  exchange::PlanePoint pixel_;
  int width_, height_;
  std::vector<std::uint8_t> pixels_;
  std::vector<double> distance_; ///< of a pixel's middle from the point it was stamped for [m]
};

/// The picture as PNG: at most 256 colours, the first one transparent.
std::string png(const Raster& raster, const std::vector<Colour>& palette);

/// "data:image/png;base64,..."
std::string data_address(const std::string& png);

} // namespace settle::compare::report
