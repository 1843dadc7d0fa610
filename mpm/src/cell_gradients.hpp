/// \file
/// The gradients with which the points of a cell feel its nodes, and are felt by them.
#pragma once

#include "settle/mpm/body.hpp"

namespace settle::mpm {

/// Points of a cell that share one gradient: all of them where gradients are constant in a cell, else a single one.
template <class Space>
struct Patch {
  PointRange points;
  double volume = 0; ///< over which their stress acts at the start of the increment [m3/m]
  const typename Space::Stencil::Gradients& gradients; ///< one column a node of the cell's [1/m]
};

/// Internal force and strain use the same gradients g_ip of node i at point p, fixed over an increment:
///
///     f_i = sum_p v_p sigma_p g_ip,        gradient of a nodal field u at p = sum_i u_i (x) g_ip
///
/// `points`: v_p = V_p and g_ip = grad N_i(x_p). `full_cells`: v_p = w_p V_c with the cell's volume V_c and
/// w_p = V_p / sum_q V_q over its points, and
///
///     g_ip = grad N_i(x_p) - sum_q w_q grad N_i(x_q) + 1/V_c integral over the cell of grad N_i
///
/// so that the weighted mean of the points' gradients is the cell's own mean, wherever they lie (as B-bar methods do
/// with the volumetric part, Hughes 1980): the full cell carries their average stress, and what they deviate by
/// resists hourglassing. Where gradients are constant in a cell, g_ip = grad N_i.
template <class Space>
class CellGradients {
public:
  using Stencil = typename Space::Stencil;

  CellGradients(const Body<Space>& body, int cell)
      : body_(body), cell_(cell), points_(points_in(body, cell)), common_(body.space.cell_average(cell)) {
    if constexpr (!Space::has_constant_gradients) collect_common_part();
  }

  /// Nodes that the cell's points touch; the order is that of all gradients.
  [[nodiscard]] int n_nodes() const { return common_.size(); }
  [[nodiscard]] int node(int i) const { return common_.node(i); }

  /// Gradients of the cell as a whole, for bodies with `mean_volume`: the volume average of the points' own.
  [[nodiscard]] const typename Stencil::Gradients& mean_gradients() const {
    if constexpr (Space::has_constant_gradients) return common_.gradients;
    return mean_;
  }

  /// Calls `action` with every patch in order. It may move and deform the points of its patch.
  template <class Action>
  void for_each_patch(Action&& action) const {
    if constexpr (Space::has_constant_gradients) {
      action(Patch<Space>{points_, integration_volume(body_, points_volume()), common_.gradients});
    } else {
      for (std::size_t p = points_.first; p < points_.last; ++p) {
        const auto gradients = gradients_at(p);
        action(Patch<Space>{{p, p + 1}, volume_ratio_ * body_.points.volume[p], gradients});
      }
    }
  }

private:
  const Body<Space>& body_;
  int cell_;
  PointRange points_;
  Stencil common_; ///< nodes of all points, and the part of the gradients that is the same at all of them
  typename Stencil::Gradients mean_;
  double volume_ratio_ = 1; ///< of the volume that the points' stress acts over to their own

  [[nodiscard]] bool full_cells() const { return body_.integration == StressIntegration::full_cells; }
  [[nodiscard]] double points_volume() const {
    double volume = 0;
    for (std::size_t p = points_.first; p < points_.last; ++p)
      volume += body_.points.volume[p];
    return volume;
  }

  /// Where a node is in the common list; it is likely to be at `hint`. Appended, with no gradient, if it is not there.
  int slot_of(int node, int hint) {
    if (const int i = find(node, hint); i >= 0) return i;
    const int i = common_.count++;
    common_.nodes[static_cast<std::size_t>(i)] = node;
    common_.gradients.col(i).setZero();
    mean_.col(i).setZero();
    return i;
  }
  [[nodiscard]] int find(int node, int hint) const {
    if (Stencil::is_shared || (hint < n_nodes() && common_.node(hint) == node)) return hint;
    for (int i = 0; i < n_nodes(); ++i)
      if (common_.node(i) == node) return i;
    return -1;
  }

  void collect_common_part() {
    const double volume = points_volume();
    volume_ratio_ = integration_volume(body_, volume) / volume;
    mean_ = common_.gradients;
    if (!full_cells()) common_.gradients.setZero();
    for (std::size_t p = points_.first; p < points_.last; ++p) {
      const Stencil own = body_.space.stencil(cell_, body_.points, p);
      const double weight = full_cells() ? body_.points.volume[p] / volume : 0.0;
      for (int i = 0; i < own.size(); ++i)
        common_.gradients.col(slot_of(own.node(i), i)) -= weight * own.gradients.col(i);
    }
  }

  [[nodiscard]] typename Stencil::Gradients gradients_at(std::size_t p) const {
    typename Stencil::Gradients gradients = common_.gradients;
    const Stencil own = body_.space.stencil(cell_, body_.points, p);
    for (int i = 0; i < own.size(); ++i)
      gradients.col(find(own.node(i), i)) += own.gradients.col(i);
    return gradients;
  }
};

} // namespace settle::mpm
