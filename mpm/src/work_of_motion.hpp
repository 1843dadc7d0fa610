/// \file
/// What the forces at the nodes do, step by step.
#pragma once

#include <vector>

#include "settle/mpm/explicit_step.hpp"

namespace settle::mpm {

/// Works of forces on the displacements of the nodes, summed over steps [J/m in 2-D]. Every point moves by what its
/// nodes move by, so that the external work is that of the points' weights, exactly. The stress work of a step is that
/// of the mean of the internal forces before and after it on its displacements, sum (sigma_before + sigma_after)/2 : d
/// epsilon V, of second order in the step.
template <int dim>
class WorkOfMotion {
public:
  /// To be told after forces have been scattered.
  void know_forces(const Nodes<dim>& nodes) {
    for (std::size_t n = 0; n < displacements_.size(); ++n)
      stress_ += 0.5 * (nodes[n].internal - forces_[n].internal).dot(displacements_[n]);
    forces_ = nodes;
  }
  /// To be told after the nodes have got their displacements. `fixed`: as of the body.
  void know_displacements(const Nodes<dim>& nodes, const std::vector<PerAxis<bool, dim>>& fixed) {
    displacements_.assign(nodes.size(), Vector<dim>::Zero());
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const NodeState<dim>& before = forces_[n];
      if (!(before.mass > 0.0)) continue;
      displacements_[n] = nodes[n].displacement;
      for (int d = 0; d < dim; ++d) {
        if (fixed[n][static_cast<std::size_t>(d)]) continue;
        const double move = nodes[n].displacement[d], unbalanced = before.external[d] - before.internal[d];
        external_ += before.external[d] * move;
        stress_ += before.internal[d] * move;
        damping_ += (unbalanced - before.mass * nodes[n].acceleration[d]) * move;
      }
    }
  }

  [[nodiscard]] double external() const { return external_; }
  [[nodiscard]] double stress() const { return stress_; }
  [[nodiscard]] double damping_loss() const { return damping_; }

private:
  Nodes<dim> forces_;
  std::vector<Vector<dim>> displacements_; ///< of the last step
  double external_ = 0, stress_ = 0, damping_ = 0;
};

} // namespace settle::mpm
