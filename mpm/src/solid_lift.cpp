#include "solid_lift.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace settle::mpm {
namespace {

/// A place along an axis that is divided into equal intervals: which one, and the share of it.
struct Along {
  int interval;
  double share;
  double slope; ///< of the share, 0 beyond the ends [1/m]
};

Along along(const exchange::Span& span, int intervals, double x) {
  const double step = span.width() / intervals, whole = (x - span.from) / step;
  const double inside = std::clamp(whole, 0.0, static_cast<double>(intervals));
  const int interval = std::min(static_cast<int>(inside), intervals - 1);
  return {interval, inside - interval, whole == inside ? 1.0 / step : 0.0};
}

/// A value between four verticals, with its slopes along x and y.
template <class Value>
struct Bilinear {
  Value value, along_x, along_y;
};

template <class Value>
Bilinear<Value> between(const std::array<Value, 4>& corners, const Along& x, const Along& y) {
  const auto& [near_left, near_right, far_left, far_right] = corners;
  const Value near = near_left + x.share * (near_right - near_left);
  const Value far = far_left + x.share * (far_right - far_left);
  return {near + y.share * (far - near),
          x.slope * ((1.0 - y.share) * (near_right - near_left) + y.share * (far_right - far_left)),
          y.slope * (far - near)};
}

} // namespace

SolidLift::SolidLift(const Verticals& verticals, bool levels_up, const std::function<Foot(double, double, bool)>& foot)
    : levels_(verticals.levels), levels_up_(levels_up), x_(verticals.x), y_(verticals.y) {
  const auto intervals = [&](const exchange::Span& span) {
    return std::max(1, static_cast<int>(std::ceil(span.width() / verticals.spacing)));
  };
  nx_ = intervals(x_), ny_ = intervals(y_);
  for (int j = 0; j <= ny_; ++j)
    for (int i = 0; i <= nx_; ++i)
      feet_.push_back(foot(x_.from + x_.width() * i / nx_, y_.from + y_.width() * j / ny_, j == 0 || j == ny_));
}

auto SolidLift::spot(const Vector<3>& place) const -> Spot {
  if (feet_.empty()) return {place, 1.0};
  const Along x = along(x_, nx_, place[0]), y = along(y_, ny_, place[1]);
  const std::array<const Foot*, 4> corners{&at(x.interval, y.interval), &at(x.interval + 1, y.interval),
                                           &at(x.interval, y.interval + 1), &at(x.interval + 1, y.interval + 1)};
  std::array<Vector<3>, 4> moves;
  std::array<double, 4> heights{};
  for (std::size_t c = 0; c < 4; ++c)
    moves[c] = corners[c]->moved, heights[c] = corners[c]->height;
  auto [move, along_x, along_y] = between(moves, x, y);
  Tensor<3> gradient = Tensor<3>::Zero(); // how much a vertical is sheared changes no volume
  gradient.col(0) = along_x, gradient.col(1) = along_y;
  if (levels_up_) { // what has settled is made up for, in proportion to the height
    const double foot = between(heights, x, y).value;
    const double thickness = levels_.high - foot;
    gradient(2, 2) = thickness > 0.0 ? -move[2] / thickness : 0.0;
    move[2] *= thickness > 0.0 ? (levels_.high - place[2]) / thickness : 0.0;
  }
  return {place + move, (Tensor<3>::Identity() + gradient).determinant()};
}

} // namespace settle::mpm
