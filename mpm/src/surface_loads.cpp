#include "settle/mpm/surface_loads.hpp"

#include "load_carriers.hpp"

namespace settle::mpm {

void SurfaceLoads::add(const std::vector<LoadedPart>& parts, const LoadCarriers& carriers,
                       const std::vector<std::uint64_t>& ids) {
  std::vector<Vector<3>>& forces = forces_.emplace_back();
  for (const LoadedPart& part : parts) {
    const Scattered& near = carriers.near(part.middle);
    const LinearFit fit = fit_linear(near, near.points.size(), part.middle);
    for (std::size_t i = 0; i < fit.points.size(); ++i) {
      const auto number = static_cast<std::size_t>(ids[fit.points[i]] - 1);
      if (forces.size() <= number) forces.resize(number + 1, Vector<3>::Zero());
      forces[number] += fit.weights[static_cast<Eigen::Index>(i)] * part.force;
    }
  }
}

template <int dim>
PointForce<dim> SurfaceLoads::at(double share_of_newest) const {
  return [this, share_of_newest](const Points<dim>& points, std::size_t p) {
    const auto place = static_cast<std::size_t>(points.id[p] - 1);
    Vector<3> force = Vector<3>::Zero();
    for (const auto& load : forces_)
      if (place < load.size()) force += (&load == &forces_.back() ? share_of_newest : 1.0) * load[place];
    Vector<dim> own;
    if constexpr (dim == 2)
      own << force[0], force[2];
    else
      own = force;
    return Vector<dim>(own / points.mass[p]);
  };
}

template PointForce<2> SurfaceLoads::at<2>(double) const;
template PointForce<3> SurfaceLoads::at<3>(double) const;

} // namespace settle::mpm
