#include "settle/mpm/viscous_damping.hpp"

#include <algorithm>
#include <cmath>

namespace settle::mpm {

template <int dim>
double ViscousDamping<dim>::damping(double dt) const {
  return 2.0 * ratio_ * frequency_ * dt;
}

template <int dim>
double ViscousDamping<dim>::kick(double dt) const {
  const double c_dt = damping(dt);
  return 2.0 * dt / (2.0 + c_dt);
}

template <int dim>
double ViscousDamping<dim>::kept(double dt) const {
  const double c_dt = damping(dt);
  return (2.0 - c_dt) / (2.0 + c_dt);
}

template <int dim>
void ViscousDamping<dim>::know_forces(const Nodes<dim>& nodes) {
  double stiffness = 0, mass = 0;
  for (std::size_t n = 0; n < last_step_.size(); ++n) {
    const Remembered& last = last_step_[n];
    if (last.mass > 0.0 && nodes[n].mass > 0.0) stiffness += last.displacement.dot(nodes[n].internal - last.internal);
    mass += last.mass * last.displacement.squaredNorm();
  }
  if (stiffness > 0.0 && mass > 0.0) { // a body that falls freely, or is at rest, tells nothing
    const double estimate = std::sqrt(stiffness / mass);
    frequency_ = frequency_ > 0.0 ? std::min(estimate, largest_rise * frequency_) : estimate;
  }
  last_step_.resize(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n)
    last_step_[n] = {.mass = nodes[n].mass, .internal = nodes[n].internal, .displacement = Vector<dim>::Zero()};
}

template <int dim>
void ViscousDamping<dim>::know_displacements(const Nodes<dim>& nodes) {
  for (std::size_t n = 0; n < nodes.size(); ++n)
    last_step_[n].displacement = nodes[n].displacement;
}

template class ViscousDamping<2>;
template class ViscousDamping<3>;

} // namespace settle::mpm
