/// \file
/// Dynamic relaxation: viscous damping that follows the lowest frequency of the body.
#pragma once

#include <vector>

#include "settle/mpm/explicit_step.hpp"

namespace settle::mpm {

/// Damping forces -c m v on the way to rest, with central differences (Underwood 1983; Papadrakakis 1981):
///
///     v_after = (2 - c dt)/(2 + c dt) v_before + 2 dt/(2 + c dt) F/m        c = 2 zeta omega
///
/// A mode of this frequency omega then dies out fastest with zeta near 1; modes above oscillate, and die out as
/// exp(-c t / 2) too. omega is that of the last step's displacement d, which comes to be the slowest mode, by
/// Rayleigh's quotient with the internal forces before and after (Oakley & Knight 1995):
///
///     omega^2 = sum d . (internal_after - internal_before) / sum m d . d
///
/// Velocities are those of the *points*, so that what cancels out in the sums of the nodes is damped as well.
template <int dim>
class ViscousDamping {
public:
  /// In one step the estimated frequency may rise by this factor, and fall freely. A point that crosses into the next
  /// cell changes internal forces although nothing stiffens, and omega jumps up to tenfold for some steps.
  static constexpr double largest_rise = 1.02;

  /// `ratio`: zeta, of the critical damping of the slowest mode [-].
  explicit ViscousDamping(double ratio) : ratio_(ratio) {}

  /// The time for which forces accelerate in a step of `dt`, 2 dt/(2 + c dt) [s].
  [[nodiscard]] double kick(double dt) const;
  /// What is left of velocities between two steps of `dt`, (2 - c dt)/(2 + c dt) [-].
  [[nodiscard]] double kept(double dt) const;

  /// To be told after forces have been scattered: estimates omega, if a step came before.
  void know_forces(const Nodes<dim>& nodes);
  /// To be told after the nodes have been moved.
  void know_displacements(const Nodes<dim>& nodes);

  [[nodiscard]] double frequency() const { return frequency_; } ///< omega [rad/s]; 0 before the second step

private:
  struct Remembered {
    double mass = 0;
    Vector<dim> internal, displacement;
  };

  [[nodiscard]] double damping(double dt) const; ///< c dt [-]

  double ratio_;
  double frequency_ = 0;
  std::vector<Remembered> last_step_; ///< by node; empty before the first step
};

} // namespace settle::mpm
