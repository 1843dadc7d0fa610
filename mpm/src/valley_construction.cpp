#include "valley_construction.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace settle::mpm {
namespace {

/// As of polygons: lengths in case files have a few digits.
constexpr double relative_slack = 1e-6;

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

} // namespace

void span_valley(const exchange::Geometry& geometry, GridBox<3>& grid) {
  const exchange::Span crest = exchange::valley_at(*geometry.valley, geometry.height);
  grid.counts[1] = static_cast<int>(std::ceil(crest.width() / grid.size * (1.0 - relative_slack))) + 2;
  grid.origin[1] = 0.5 * (crest.from + crest.to - grid.counts[1] * grid.size);
}

bool is_beyond_flanks(const exchange::Valley& valley, const Vector<3>& node, double size) {
  const exchange::Span flanks = exchange::valley_at(valley, node[2]);
  const double slack = relative_slack * size;
  return node[1] <= flanks.from + slack || node[1] >= flanks.to - slack;
}

ValleyLift::ValleyLift(const exchange::Case& study, int layer, const PresentLayers<3>& below, double spacing)
    : levels_(levels_of_layer(study.geometry, layer)),
      levels_up_(study.construction.convention == exchange::Convention::level_up) {
  x_ = exchange::fill_at(*study.geometry.embankment, levels_.low);
  y_ = exchange::valley_at(*study.geometry.valley, levels_.low);
  if (study.construction.convention == exchange::Convention::drop || !(y_.width() > 0.0)) return;
  const auto intervals = [&](const exchange::Span& span) {
    return std::max(1, static_cast<int>(std::ceil(span.width() / spacing)));
  };
  nx_ = intervals(x_), ny_ = intervals(y_);
  for (int j = 0; j <= ny_; ++j)
    for (int i = 0; i <= nx_; ++i) {
      const Place foot(x_.from + x_.width() * i / nx_, y_.from + y_.width() * j / ny_, levels_.low);
      const bool on_flank = j == 0 || j == ny_;
      moved_.push_back(on_flank ? Vector<3>(Vector<3>::Zero()) : Vector<3>(below.surface(foot) - foot));
    }
}

auto ValleyLift::spot(const Vector<3>& place) const -> Spot {
  if (moved_.empty()) return {place, 1.0};
  const Along x = along(x_, nx_, place[0]), y = along(y_, ny_, place[1]);
  const Vector<3>&near_left = moved(x.interval, y.interval), &near_right = moved(x.interval + 1, y.interval);
  const Vector<3>&far_left = moved(x.interval, y.interval + 1), &far_right = moved(x.interval + 1, y.interval + 1);
  const Vector<3> near = near_left + x.share * (near_right - near_left);
  const Vector<3> far = far_left + x.share * (far_right - far_left);
  Vector<3> move = near + y.share * (far - near);
  Tensor<3> gradient = Tensor<3>::Zero();
  gradient.col(0) = x.slope * ((1.0 - y.share) * (near_right - near_left) + y.share * (far_right - far_left));
  gradient.col(1) = y.slope * (far - near);
  if (levels_up_) { // what has settled is made up for, in proportion to the height
    const double thickness = levels_.high - levels_.low, left = (levels_.high - place[2]) / thickness;
    gradient.row(2) *= left;
    gradient(2, 2) = -move[2] / thickness;
    move[2] *= left;
  }
  return {place + move, (Tensor<3>::Identity() + gradient).determinant()};
}

} // namespace settle::mpm
