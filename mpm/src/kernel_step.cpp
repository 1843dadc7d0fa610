// The phases of the explicit step by the kernels.

#include "kernel_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constitutive_update.hpp"

namespace settle::mpm {

template <class Space>
const kernel::Phases& KernelStep<Space>::phases_of(const kernel::Variant& variant) {
  if constexpr (std::is_same_v<Space, TriangleSpace>) return *variant.triangles;
  if constexpr (std::is_same_v<Space, TetrahedronSpace>) return *variant.tetrahedra;
  if constexpr (std::is_same_v<Space, BoxSpace<dim>>) return dim == 2 ? *variant.quadrilaterals : *variant.hexahedra;
  return dim == 2 ? *variant.plane_b_splines : *variant.solid_b_splines;
}

template <class Space>
KernelStep<Space>::KernelStep(Body<Space>& body, int threads, const kernel::Variant& variant)
    : body_(body), phases_(phases_of(variant)), threads_(threads) {
  step_.kept = 1.0;
  set_grid();
  set_material();
  allocate_nodes();
  const Size n = size_of(step_.n_strips);
  touched_.assign(n, 0), active_.assign(n + 1, 0);
  weight_.resize(n), sums_.resize(n + 1), layers_.resize(n);
  const Size tiles = n * size_of(step_.strip_tiles);
  strays_.resize(tiles), stray_arrays_.resize(tiles), crossings_.resize(tiles);
  step_.touched = touched_.data(), step_.weight = weight_.data(), step_.sums = sums_.data();
  step_.strays = stray_arrays_.data();
  step_.context = this, step_.crossed = crossed, step_.deform = deform;
}

template <class Space>
void KernelStep<Space>::set_gravity(const Gravity& gravity) {
  step_.gravity = gravity.acceleration;
  step_.ramped_gravity = gravity.factor * gravity.acceleration;
  step_.ramped_layer = gravity.ramped_layer;
  for (Size s = 0; s < weight_.size(); ++s) {
    const auto [lowest, highest] = layers_[s];
    const bool alike = lowest == highest || step_.gravity == step_.ramped_gravity || gravity.ramped_layer < lowest ||
                       gravity.ramped_layer > highest;
    weight_[s] = {.kind = alike ? kernel::Weight::uniform : kernel::Weight::by_layer, .gravity = gravity.on(lowest)};
    if (dim == 2 && gravity.besides) weight_[s].kind = kernel::Weight::with_force;
  }
  if constexpr (dim == 2)
    if (gravity.besides) find_force(gravity);
}

template <class Space>
void KernelStep<Space>::find_force(const Gravity& gravity) requires(dim == 2) {
  gather();
  for (auto& component : force_)
    component.resize(body_.points.size());
  for (Size p = 0; p < body_.points.size(); ++p) {
    const Vector<dim> force = gravity.besides(body_.points, p);
    for (int d = 0; d < dim; ++d)
      force_[size_of(d)][p] = force[d];
  }
  for (int d = 0; d < dim; ++d)
    step_.points.force[d] = force_[size_of(d)].data();
  if (step_.node[Array::external(0)] == nullptr) allocate_nodes(Array::external(0));
}

/// Nodes carry something where their strip or the one below holds points; others are cleared once.
template <class Space>
void KernelStep<Space>::activate_strips() {
  for (int strip = 0; strip <= step_.n_strips; ++strip) {
    const Size s = size_of(strip);
    const bool active = (strip < step_.n_strips && touched_[s] != 0) || (strip > 0 && touched_[s - 1] != 0);
    if (active_[s] != 0 && !active) clear_nodes(strip);
    active_[s] = active ? 1 : 0;
  }
}

template <class Space>
void KernelStep<Space>::clear_nodes(int strip) {
  const Size columns = size_of(step_.node_columns);
  const auto row = [&](int s) { return std::min(step_.rows, s * step_.strip_rows); }; // the last strip may be short
  const int last = strip == step_.n_strips ? step_.rows + step_.overlap : row(strip + 1);
  for (int k = 0; k < step_.n_node_arrays; ++k)
    if (step_.node[k] != nullptr)
      std::fill(step_.node[k] + size_of(row(strip)) * columns, step_.node[k] + size_of(last) * columns, 0.0);
}

template <class Space>
void KernelStep<Space>::scatter(const Gravity& gravity) {
  if (sorts_ != body_.cells.sorts) take_stock();
  set_gravity(gravity);
  activate_strips();
  for (Size s = 0; s < strays_.size(); ++s)
    stray_arrays_[s] = strays_[s].arrays();
  crew_.run(shares_, [&](int strip, int thread) {
    if (strip < step_.n_strips && touched_[size_of(strip)] != 0)
      phases_.scatter(step_, strip, scratch_of_[size_of(thread)]);
  });
  nodes_complete_ = false;
}

template <class Space>
double KernelStep<Space>::stable_time_step(double courant) const {
  double slowness_squared = std::numeric_limits<double>::infinity();
  for (Size s = 0; s < touched_.size(); ++s)
    if (touched_[s] != 0) slowness_squared = std::min(slowness_squared, sums_[s].slowness_squared);
  return courant * body_.space.shortest_length() * std::sqrt(slowness_squared);
}

template <class Space>
std::vector<double> KernelStep<Space>::column_heights() const {
  std::vector<double> heights(size_of(step_.columns), 0.0);
  for (Size s = 0; s < touched_.size(); ++s)
    for (Size column = 0; touched_[s] != 0 && column < heights.size(); ++column)
      heights[column] += column_volume_[s * heights.size() + column];
  for (double& height : heights)
    height = body_.space.origin()[dim - 1] + height / body_.space.column_area();
  return heights;
}

template <class Space>
ForceSums KernelStep<Space>::accelerate(double damping) {
  step_.damping = damping;
  crew_.run(shares_, [&](int strip, int) {
    if (is_active(strip)) phases_.accelerate(step_, strip);
  });
  nodes_complete_ = true;
  ForceSums sums;
  for (int strip = 0; strip <= step_.n_strips; ++strip) {
    if (!is_active(strip)) continue;
    const kernel::StripSums& own = sums_[size_of(strip)];
    sums.unbalanced += own.unbalanced, sums.external += own.external, sums.base_reaction += own.base_reaction;
  }
  return sums;
}

template <class Space>
StepEnergy KernelStep<Space>::displace(double kick, double dt, double kept) {
  step_.kick = kick, step_.dt = dt, step_.kept = kept;
  crew_.run(shares_, [&](int strip, int) {
    if (is_active(strip)) phases_.displace(step_, strip);
  });
  StepEnergy energy;
  for (int strip = 0; strip <= step_.n_strips; ++strip) {
    if (!is_active(strip)) continue;
    energy.kinetic += sums_[size_of(strip)].kinetic, energy.external_work += sums_[size_of(strip)].external_work;
  }
  return energy;
}

template <class Space>
void KernelStep<Space>::move() {
  crew_.run(shares_, [&](int strip, int thread) {
    if (strip < step_.n_strips && touched_[size_of(strip)] != 0)
      phases_.move(step_, strip, scratch_of_[size_of(thread)]);
  });
  sort_out_crossings();
  if (body_.average_stress) replace_stress_by_cell_average(body_);
}

template <class Space>
void KernelStep<Space>::deform(void* context, Size first, int count, const double* gradient, Size stride) {
  for (Size q = 0; q < size_of(count); ++q) {
    Tensor<dim> g;
    for (int k = 0; k < dim * dim; ++k)
      g(k / dim, k % dim) = gradient[size_of(k) * stride + q];
    deform_points(static_cast<KernelStep*>(context)->body_, {first + q, first + q + 1}, IncrementalKinematics<dim>(g),
                  StrainMeasure::midpoint);
  }
}

template <class Space>
auto KernelStep<Space>::node_row(int row) const -> NodeRow {
  const int strip = row >= step_.rows ? step_.n_strips : row / step_.strip_rows;
  const int row_of_strip = row - (strip == step_.n_strips ? step_.rows : strip * step_.strip_rows);
  const auto touched = [&](int s) { return s >= 0 && s < step_.n_strips && touched_[size_of(s)] != 0; };
  const bool completes = !nodes_complete_ && row_of_strip < step_.overlap && touched(strip - 1);
  const Size columns = size_of(step_.node_columns);
  NodeRow numbers;
  numbers.own.fill(zeros_.data()), numbers.from_below.fill(zeros_.data());
  for (int k = 0; k < Array::matrix; ++k) {
    if (step_.node[k] == nullptr) continue;
    if (nodes_complete_ || touched(strip)) numbers.own[size_of(k)] = step_.node[k] + size_of(row) * columns;
    if (completes)
      numbers.from_below[size_of(k)] = step_.overlap_nodes +
                                       size_of((strip - 1) * step_.n_node_arrays + k) * step_.overlap_stride +
                                       size_of(row_of_strip) * columns;
  }
  return numbers;
}

template <class Space>
auto KernelStep<Space>::node(int node) const -> NodeState<dim> {
  return node_row(node / step_.node_columns).node(size_of(node % step_.node_columns));
}

template <class Space>
void KernelStep<Space>::read_nodes(Nodes<dim>& nodes) const {
  const Size columns = size_of(step_.node_columns);
  nodes.resize(size_of(step_.rows + step_.overlap) * columns);
  for (int row = 0; row < step_.rows + step_.overlap; ++row) {
    const NodeRow numbers = node_row(row);
    for (Size column = 0; column < columns; ++column)
      nodes[size_of(row) * columns + column] = numbers.node(column);
  }
}

template <class Space>
void KernelStep<Space>::set_displacement(int node, const Vector<dim>& displacement) {
  nodes_complete_ = true;
  for (int d = 0; d < dim; ++d)
    step_.node[Array::momentum + d][node] = displacement[d];
}

#define SETTLE_INSTANTIATE(Space) template class KernelStep<Space>;
SETTLE_FOR_EVERY_SPACE_WITH_KERNELS(SETTLE_INSTANTIATE)

} // namespace settle::mpm
