/// \file
/// One implicit, quasi-static increment: Newton on the nodes' displacements, then points are moved.
#pragma once

#include <memory>
#include <vector>

#include "settle/mpm/body.hpp"

namespace settle::mpm {

/// What an increment did.
struct IncrementReport {
  bool converged = false;
  int linear_solves = 0;
  double out_of_balance = 0;       ///< free nodes' unbalanced force over all external forces, or over the internal ones
                                   ///< of the first iteration where these are larger, Euclidean norms [-]
  double base_reaction = 0;        ///< positive upward [N/m] in 2-D
  double largest_displacement = 0; ///< of a node in this increment [m]
  std::vector<double> residuals;   ///< out of balance before each linear solve and at the end
  Eigen::VectorXd reactions;       ///< of the supports on the body, (dim * nodes), zero where free [N/m] in 2-D
};

/// Threads of an increment: no more than there are so many points for each. Results do not depend on them.
struct Threads {
  int most = 1;
  std::size_t least_points = 10'000;
};

template <class Space>
class QuasiStaticSystem;

/// Equilibrium at the end of the increment, on the grid as it deforms in the increment (updated Lagrangian): for every
/// free node i  sum_p v_p J_p sigma_p F_p^-T g_ip = sum_p N_i m g,  with sigma_p the stress at the end of the
/// increment, F_p the increment's deformation gradient at p, and v_p and g_ip by `StressIntegration`. The tangent is
/// its exact derivative (unsymmetric). What is known of the linear system, from its pattern to its factorisation, is
/// kept while the points touch the same nodes.
template <class Space>
class QuasiStaticStep {
public:
  /// `tolerance`: relative out-of-balance force at which an increment has converged.
  explicit QuasiStaticStep(double tolerance, exchange::MpmLinearSolver solver = exchange::MpmLinearSolver::direct,
                           Threads threads = {});
  QuasiStaticStep(QuasiStaticStep&&) noexcept;
  ~QuasiStaticStep();

  /// Balances `fraction` of what is out of balance between the body's stresses and gravity, while supports move by
  /// `support_motion` (dim * nodes, zero where nothing is held; empty: none moves) [m]. The body moves only if the
  /// Newton iteration converges; then its points are moved and sorted. Throws PointLost.
  IncrementReport advance(Body<Space>& body, const Gravity& gravity, double fraction = 1.0,
                          const Eigen::VectorXd& support_motion = {});

private:
  std::unique_ptr<QuasiStaticSystem<Space>> system_;
  double tolerance_;
};

} // namespace settle::mpm
