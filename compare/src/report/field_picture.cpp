#include "field_picture.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "field_difference.hpp"
#include "format.hpp"
#include "settle/exchange/valley.hpp"

namespace settle::compare::report {

namespace {

using exchange::Case;
using exchange::PlaneBox;
using exchange::PlanePoint;
using exchange::Quantity;
using exchange::Result;

bool is_within(const PlaneBox& box, const PlanePoint& point) { // false for NaN
  return point[0] >= box.lowest[0] && point[0] <= box.highest[0] && point[1] >= box.lowest[1] &&
         point[1] <= box.highest[1];
}

PlaneBox design_box(const Case& study) {
  if (study.geometry.drawn()) return exchange::bounding_box(study.geometry);
  return {.lowest = {0.0, 0.0}, .highest = {study.geometry.width, study.geometry.height}};
}

void grow(PlaneBox& box, const PlanePoint& point, double around) {
  for (std::size_t d = 0; d < 2; ++d) {
    box.lowest[d] = std::min(box.lowest[d], point[d] - around);
    box.highest[d] = std::max(box.highest[d], point[d] + around);
  }
}

/// Points and what they say, as far as they can be drawn.
struct Drawable {
  std::vector<Spot> spots;
  std::vector<std::size_t> index; ///< of each in the result
  std::size_t without_value = 0, far_off = 0;
};

/// A vertical cut through the middle of a body in space; in 2-D it holds all points.
class Cut {
public:
  Cut(const Case& study, const exchange::SamplePoints& points)
      : points_(points), is_plane_(study.geometry.dimension == 2), middle_(exchange::middle_of_depth(study.geometry)) {
    for (std::size_t i = 0; !is_plane_ && i < points.size(); ++i) {
      double& nearest = nearest_.try_emplace(points.layer[i], distance(i)).first->second;
      nearest = std::min(nearest, distance(i));
    }
  }

  /// Does its volume reach the cut, or is it among the nearest of its layer, as where elements are long across it?
  [[nodiscard]] bool holds(std::size_t i) const {
    constexpr double same_row = 2.0; // the next row is further off by more than this factor
    return is_plane_ ||
           distance(i) <= std::max(0.75 * std::cbrt(points_.volume[i]), same_row * nearest_.at(points_.layer[i]));
  }

private:
  [[nodiscard]] double distance(std::size_t i) const { return std::abs(points_.position[3 * i + 1] - middle_); }

  const exchange::SamplePoints& points_;
  bool is_plane_;
  double middle_;
  std::map<int, double> nearest_; ///< distance of the nearest point of a layer [m]
};

Drawable drawable(const Case& study, const exchange::SamplePoints& points, Quantity quantity) {
  const auto dim = static_cast<std::size_t>(study.geometry.dimension);
  const double factor = axis_of(quantity).factor;
  const double size_of_cube = 1.0 / static_cast<double>(dim);
  const PlaneBox view = widest_view(study);
  const Cut cut(study, points);
  Drawable found;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!cut.holds(i)) continue;
    const PlanePoint at{points.position[dim * i], points.position[dim * i + dim - 1]};
    const double value = factor * value_at(points, dim, i, quantity);
    // Half the diagonal of its square: neighbours on a square lattice touch all round.
    const double radius = std::pow(points.volume[i], size_of_cube) / std::sqrt(2.0);
    if (!std::isfinite(value) || !std::isfinite(at[0]) || !std::isfinite(at[1]) || !std::isfinite(radius)) {
      ++found.without_value;
    } else if (!is_within(view, at)) {
      ++found.far_off;
    } else {
      found.spots.push_back({at, radius, value});
      found.index.push_back(i);
    }
  }
  return found;
}

bool is_drawn_by_elements(const Case& study, const SolverRun& solver) {
  return solver.solver == "fem" && study.geometry.dimension == 2 &&
         come_in_elements(solver.result->stages.back().points, points_along_edge(study));
}

/// Elements instead of spots.
void draw_elements(const Case& study, const exchange::SamplePoints& points, const Drawable& found, FieldLeg& leg) {
  const int along = points_along_edge(study);
  const std::vector<Quadrilateral> parts = parts_of_elements(points.position, along);
  for (std::size_t k = 0; k < found.spots.size(); ++k)
    leg.patches.push_back({parts[found.index[k]], found.spots[k].value});
  leg.drawn = fmt::format("{} elements, {} values in each", points.size() / static_cast<std::size_t>(along * along),
                          along * along);
}

std::string kind_of_points(const SolverRun& solver) {
  if (solver.solver == "mpm") return "material points";
  return solver.solver == "fem" ? "quadrature points" : "sample points";
}

FieldLeg leg_of(const RunOutcome& run, const SolverRun& solver, Quantity quantity, FieldPicture& picture) {
  const exchange::SamplePoints& points = solver.result->stages.back().points;
  Drawable found = drawable(run.study, points, quantity);
  FieldLeg leg{.title = title_of(solver), .drawn = {}, .spots = {}, .patches = {}, .range = {}};
  for (const Spot& spot : found.spots)
    leg.range.include(spot.value);
  if (found.without_value > 0)
    picture.missing.push_back(
        fmt::format("{}: {} points have no value and are left out", leg.title, found.without_value));
  if (found.far_off > 0)
    picture.missing.push_back(fmt::format("{}: {} points have left the picture", leg.title, found.far_off));
  if (is_drawn_by_elements(run.study, solver)) {
    draw_elements(run.study, points, found, leg);
  } else {
    leg.drawn = fmt::format("{} {}", found.spots.size(), kind_of_points(solver));
    leg.spots = std::move(found.spots);
  }
  return leg;
}

void add_remarks(const RunOutcome& run, FieldPicture& picture) {
  const auto frozen = [](const SolverRun& solver) {
    return solver.result && solver.result->used.kinematics == exchange::Kinematics::small;
  };
  const bool any_frozen = std::any_of(run.solvers.begin(), run.solvers.end(), frozen);
  if (any_frozen && run.study.n_stages() > 1)
    picture.remarks.emplace_back(
        "With small strain a layer is placed where it is designed: between two layers lies the "
        "gap that had settled before the upper one came.");
  const Result* mpm = run.result_of("mpm");
  const bool refilled = mpm != nullptr && !mpm->stages.empty() &&
                        std::any_of(mpm->stages.back().points.refilled.begin(),
                                    mpm->stages.back().points.refilled.end(), [](auto flag) { return flag != 0; });
  if (refilled && picture.quantity == Quantity::settlement)
    picture.remarks.emplace_back("Points that were added to make up for settlement are drawn too; theirs counts from "
                                 "when they were added.");
  if (run.study.geometry.dimension == 3)
    picture.remarks.emplace_back(
        "A vertical cut: the points nearest to the middle of the depth, of a valley to that of its floor.");
}

} // namespace

void ValueRange::include(double value) {
  lowest = std::min(lowest, value);
  highest = std::max(highest, value);
}

void ValueRange::include(const ValueRange& other) {
  if (other.empty()) return;
  include(other.lowest);
  include(other.highest);
}

PlaneBox widest_view(const Case& study) {
  const PlaneBox design = design_box(study);
  const double around = 0.5 * std::max(design.highest[0] - design.lowest[0], design.highest[1] - design.lowest[1]);
  return {.lowest = {design.lowest[0] - around, design.lowest[1] - around},
          .highest = {design.highest[0] + around, design.highest[1] + around}};
}

PlaneBox view_of(const RunOutcome& run, const FieldPicture& picture) {
  PlaneBox view = design_box(run.study);
  for (const FieldLeg& leg : picture.legs) {
    for (const Spot& spot : leg.spots)
      grow(view, spot.at, spot.radius / std::sqrt(2.0));
    for (const Patch& patch : leg.patches)
      for (const PlanePoint& corner : patch.corners)
        grow(view, corner, 0.0);
  }
  const PlaneBox widest = widest_view(run.study);
  for (std::size_t d = 0; d < 2; ++d) {
    view.lowest[d] = std::max(view.lowest[d], widest.lowest[d]);
    view.highest[d] = std::min(view.highest[d], widest.highest[d]);
  }
  return view;
}

FieldPicture field_picture_of(const RunOutcome& run, Quantity quantity) {
  FieldPicture picture;
  picture.quantity = quantity;
  for (const SolverRun& solver : run.solvers) {
    if (!solver.result || solver.result->stages.empty()) {
      picture.missing.push_back(fmt::format("{}: it has no result", title_of(solver)));
    } else if (solver.result->stages.back().points.size() == 0) {
      picture.missing.push_back(fmt::format("{}: it gives values at probes only", title_of(solver)));
    } else {
      picture.legs.push_back(leg_of(run, solver, quantity, picture));
      picture.scale.include(picture.legs.back().range);
    }
  }
  picture.difference = field_difference(run, quantity, picture.missing);
  add_remarks(run, picture);
  return picture;
}

} // namespace settle::compare::report
