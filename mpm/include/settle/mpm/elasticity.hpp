/// \file
/// Isotropic elasticity of the material point method: the hypoelastic law `rate`, Cauchy stress rate = D : d.
#pragma once

#include "settle/mpm/points.hpp"

namespace settle::mpm {

/// Lamé's constants [Pa].
struct Lame {
  double lambda = 0;
  double mu = 0;

  /// From Young's modulus [Pa] and Poisson's ratio in (-1, 1/2).
  static Lame from(double youngs_modulus, double poissons_ratio);
  /// Back to the two constants of the case file.
  [[nodiscard]] double youngs_modulus() const { return mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu); }
  [[nodiscard]] double poissons_ratio() const { return 0.5 * lambda / (lambda + mu); }
  /// Constrained (oedometric) modulus M = lambda + 2 mu [Pa], the stiffness of the fastest wave.
  [[nodiscard]] double constrained_modulus() const { return lambda + 2.0 * mu; }
};

/// Stress of a plane-strain or 3-D state: the tensor in the space of the grid and, in plane strain, the component
/// across it (unused in 3-D, where the tensor holds zz).
template <int dim>
struct Stress {
  Tensor<dim> tensor = Tensor<dim>::Zero();
  double out_of_plane = 0;
};

/// The stress with the components `component(c)` in their stored order, see `stress_size`.
template <int dim, class Component>
Stress<dim> stress_of_components(Component&& component) {
  Stress<dim> stress;
  if constexpr (dim == 2) {
    stress.tensor << component(0), component(3), component(3), component(1);
    stress.out_of_plane = component(2);
  } else {
    stress.tensor << component(0), component(3), component(5), //
        component(3), component(1), component(4),              //
        component(5), component(4), component(2);
  }
  return stress;
}

/// The components of a stress in their stored order.
template <int dim>
std::array<double, stress_size<dim>> components_of(const Stress<dim>& stress) {
  const Tensor<dim>& t = stress.tensor;
  if constexpr (dim == 2)
    return {t(0, 0), t(1, 1), stress.out_of_plane, t(0, 1)};
  else
    return {t(0, 0), t(1, 1), t(2, 2), t(0, 1), t(1, 2), t(0, 2)};
}

template <int dim>
Stress<dim> stress_of(const Points<dim>& points, std::size_t p) {
  return stress_of_components<dim>([&](std::size_t c) { return points.stress[c][p]; });
}

template <int dim>
void set_stress(Points<dim>& points, std::size_t p, const Stress<dim>& stress) {
  const auto components = components_of(stress);
  for (std::size_t c = 0; c < components.size(); ++c)
    points.stress[c][p] = components[c];
}

/// Stress increment of an increment of strain (small against one): lambda tr(e) I + 2 mu e. Plane strain in 2-D.
template <int dim>
Stress<dim> stress_increment(const Lame& lame, const Tensor<dim>& strain) {
  const double volumetric = lame.lambda * strain.trace();
  return {volumetric * Tensor<dim>::Identity() + 2.0 * lame.mu * strain, volumetric};
}

} // namespace settle::mpm
