#include "settle/mpm/surface_loads.hpp"

#include <algorithm>
#include <cmath>

namespace settle::mpm {
namespace {

/// Parts of the line, each of which is carried on its own, as long as a quarter of the points' spacing.
constexpr double parts_per_spacing = 4.0;
/// The points in the cell of the one that is nearest to the place: what they carry goes to the nodes of that cell, so
/// that an even load on the whole side of a cell comes to its nodes as it should.
Scattered in_the_nearest_cell(const Scattered& points, const Points<2>& all, const Place& place) {
  const auto nearest =
      std::min_element(points.places.begin(), points.places.end(), [&](const Place& a, const Place& b) {
        return (a - place).squaredNorm() < (b - place).squaredNorm();
      });
  const std::int32_t cell = all.cell[points.points[static_cast<std::size_t>(nearest - points.places.begin())]];
  Scattered inside;
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    if (all.cell[points.points[i]] != cell) continue;
    inside.points.push_back(points.points[i]);
    inside.places.push_back(points.places[i]);
  }
  return inside;
}

} // namespace

void SurfaceLoads::add(const exchange::StageEntry& entry, const Scattered& points, const Points<2>& all,
                       double spacing) {
  const Vector<2> from(entry.from[0], entry.from[1]), to(entry.to[0], entry.to[1]);
  const Vector<2> traction(entry.traction[0], entry.traction[1]);
  const double length = (to - from).norm();
  const int parts = std::max(1, static_cast<int>(std::ceil(parts_per_spacing * length / spacing)));
  std::vector<Vector<2>>& forces = forces_.emplace_back();
  for (int part = 0; part < parts; ++part) {
    const Vector<2> middle = from + (part + 0.5) / parts * (to - from);
    const Place place(middle[0], 0.0, middle[1]);
    const Scattered carriers = in_the_nearest_cell(points, all, place);
    const LinearFit fit = fit_linear(carriers, carriers.points.size(), place);
    for (std::size_t i = 0; i < fit.points.size(); ++i) {
      const auto number = static_cast<std::size_t>(all.id[fit.points[i]] - 1);
      if (forces.size() <= number) forces.resize(number + 1, Vector<2>::Zero());
      forces[number] += fit.weights[static_cast<Eigen::Index>(i)] * length / parts * traction;
    }
  }
}

std::function<Vector<2>(const Points<2>&, std::size_t)> SurfaceLoads::at(double share_of_newest) const {
  return [this, share_of_newest](const Points<2>& points, std::size_t p) {
    const auto place = static_cast<std::size_t>(points.id[p] - 1);
    Vector<2> force = Vector<2>::Zero();
    for (const auto& load : forces_)
      if (place < load.size()) force += (&load == &forces_.back() ? share_of_newest : 1.0) * load[place];
    return Vector<2>(force / points.mass[p]);
  };
}

} // namespace settle::mpm
