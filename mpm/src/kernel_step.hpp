/// \file
/// The explicit step by the kernels: simplices, quadrilaterals, hexahedra and B-splines on structured grids.
#pragma once

#include "crew.hpp"
#include "kernel/variants.hpp"
#include "settle/mpm/explicit_step.hpp"
#include "settle/mpm/spaces.hpp"
#include "strays.hpp"

namespace settle::mpm {

/// Has this space kernels? The others go point by point.
template <class Space>
inline constexpr bool has_kernels = !Space::has_domains;

#define SETTLE_FOR_EVERY_SPACE_WITH_KERNELS(X)                                                                         \
  X(TriangleSpace)                                                                                                     \
  X(QuadrilateralSpace)                                                                                                \
  X(BSplineSpace<2>)                                                                                                   \
  X(TetrahedronSpace)                                                                                                  \
  X(HexahedronSpace)                                                                                                   \
  X(BSplineSpace<3>)

/// The phases of ExplicitStep. Rows of squares are taken in strips, and their lines in tiles, that depend on the grid
/// alone, and every sum is over a tile and a strip first: results do not depend on the number of threads.
template <class Space>
class KernelStep {
public:
  static constexpr int dim = Space::dim;

  explicit KernelStep(Body<Space>& body, int threads = 1, const kernel::Variant& variant = kernel::best_variant());
  KernelStep(const KernelStep&) = delete; // the kernels point into it
  KernelStep& operator=(const KernelStep&) = delete;
  ~KernelStep() = default;

  void scatter(const Gravity& gravity);
  [[nodiscard]] double stable_time_step(double courant) const;
  [[nodiscard]] std::vector<double> column_heights() const;
  ForceSums accelerate(double damping);
  StepEnergy displace(double kick, double dt, double kept = 1.0);
  void move();
  void gather();

  [[nodiscard]] NodeState<dim> node(int node) const;
  void read_nodes(Nodes<dim>& nodes) const;
  void set_displacement(int node, const Vector<dim>& displacement);

private:
  using Size = std::size_t;
  using Array = kernel::NodeArrays<dim>;
  static Size size_of(int i) { return static_cast<Size>(i); }

  /// What a strip's points have in common since they were sorted.
  struct Layers {
    std::int32_t lowest, highest;
  };
  /// A row of nodes, by array: what its own strip has summed, and what the strip below adds; or zeros.
  struct NodeRow {
    std::array<const double*, Array::matrix> own, from_below;

    [[nodiscard]] NodeState<dim> node(Size column) const {
      const auto value = [&](int k) { return own[size_of(k)][column] + from_below[size_of(k)][column]; };
      NodeState<dim> state{.mass = value(Array::mass)};
      for (int d = 0; d < dim; ++d) {
        state.momentum[d] = state.displacement[d] = value(Array::momentum + d);
        state.internal[d] = state.acceleration[d] = value(Array::force + d);
        state.external[d] = value(Array::external(d));
      }
      return state;
    }
  };
  struct Crossing {
    Size index;
    bool stray;
  };

  Body<Space>& body_;
  const kernel::Phases& phases_;
  int threads_;
  Crew crew_;
  Shares shares_; ///< of the strips
  kernel::Step step_{};
  std::uint64_t sorts_ = 0; ///< of the body, as known here
  bool nodes_complete_ = false;

  std::array<std::vector<double>, kernel::max_node_arrays> nodes_;
  std::vector<double> zeros_; ///< a row of nodes
  std::vector<double> overlap_nodes_, mean_, column_volume_;
  PerAxis<std::vector<double>, dim> force_;
  std::vector<std::vector<double>> scratch_;
  std::vector<kernel::Scratch> scratch_of_; ///< by thread
  std::vector<std::uint8_t> held_, touched_, active_;
  std::vector<kernel::StripWeight> weight_;
  std::vector<kernel::StripSums> sums_;
  std::vector<Layers> layers_;          ///< by strip
  std::vector<TileStrays<dim>> strays_; ///< by tile, as all that follows
  std::vector<kernel::Strays> stray_arrays_;
  std::vector<std::vector<Crossing>> crossings_;
  Size n_strays_ = 0;

  [[nodiscard]] static const kernel::Phases& phases_of(const kernel::Variant& variant);
  [[nodiscard]] Size tile_of(int cell) const;
  [[nodiscard]] Size strip_of(Size tile) const { return tile / size_of(step_.strip_tiles); }
  [[nodiscard]] bool may_stray() const;
  [[nodiscard]] bool is_active(int strip) const { return active_[size_of(strip)] != 0; }

  [[nodiscard]] NodeRow node_row(int row) const;

  void set_grid();
  void divide_rows();
  void set_material();
  void allocate_nodes();
  void allocate_nodes(int array);
  void allocate_scratch();
  void take_stock();
  void point_to_points();
  void set_gravity(const Gravity& gravity);
  void find_force(const Gravity& gravity) requires(dim == 2);
  void activate_strips();
  void clear_nodes(int strip);
  void note(Size strip, std::int32_t layer);
  void sort_out_crossings();
  void sort_by_known_cells();
  bool take_stray(Size p);
  void move_stray(Size tile, Size i);
  [[nodiscard]] int locate(const Vector<dim>& x, Size p) const;
  [[nodiscard]] Vector<dim> centre_of(int cell) const;

  static void crossed(void* context, int tile, bool stray, Size index);
  static void deform(void* context, Size first, int count, const double* gradient, Size stride);
};

} // namespace settle::mpm
