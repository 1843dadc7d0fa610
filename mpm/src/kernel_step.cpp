#include "kernel_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constitutive_update.hpp"

namespace settle::mpm {

namespace {

using Size = std::size_t;

constexpr Size lanes = 8;                  ///< kernels read and write so many numbers at a time
constexpr int strip_squares = 256;         ///< at least, so that loops over a strip are long
constexpr int most_stray_share = 32;       ///< points are sorted once more than 1/32 of them have strayed
constexpr int least_strays = 8;            ///< or more than these, in small bodies
constexpr Size points_per_thread = 10'000; ///< below this a thread costs more than it brings

Size size_of(int i) {
  return static_cast<Size>(i);
}

Size rounded_up(Size n, Size to) {
  return (n + to - 1) / to * to;
}

/// The first number of a vector that starts a cache line.
double* aligned(std::vector<double>& values) {
  const auto address = reinterpret_cast<std::uintptr_t>(values.data());
  return values.data() + (rounded_up(address, 64) - address) / sizeof(double);
}

} // namespace

template <class Space>
const kernel::Phases& KernelStep<Space>::phases_of(const kernel::Variant& variant) {
  if constexpr (std::is_same_v<Space, TriangleSpace>) return variant.triangles;
  if constexpr (std::is_same_v<Space, QuadrilateralSpace>) return variant.quadrilaterals;
  return variant.b_splines;
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
  weight_.resize(n), sums_.resize(n + 1), layers_.resize(n), strays_.resize(n), stray_arrays_.resize(n);
  crossings_.resize(n);
  step_.touched = touched_.data(), step_.weight = weight_.data(), step_.sums = sums_.data();
  step_.strays = stray_arrays_.data();
  step_.context = this, step_.crossed = crossed, step_.deform = deform;
}

template <class Space>
void KernelStep<Space>::set_grid() {
  const Space& space = body_.space;
  step_.columns = space.columns(), step_.rows = space.rows(), step_.node_columns = space.node_columns();
  step_.overlap = space.node_columns() - space.columns();
  const int wanted = (strip_squares + step_.node_columns - 1) / step_.node_columns;
  step_.strip_rows = std::min(step_.rows, std::max(4 / step_.overlap, wanted));
  while (step_.rows % step_.strip_rows != 0 && step_.rows % step_.strip_rows < step_.overlap)
    ++step_.strip_rows; // also the last strip owns all nodes that the one below adds to
  step_.n_strips = (step_.rows + step_.strip_rows - 1) / step_.strip_rows;
  for (int d = 0; d < dim; ++d)
    step_.origin[d] = space.origin()[d];
  step_.inverse_size = 1.0 / space.size();
  step_.cell_volume = space.cell_volume();
  step_.full_cells = body_.integration == StressIntegration::full_cells;
  const int c = step_.node_columns;
  int edge = 0;
  for (int up = 0; up <= step_.overlap; ++up)
    for (int right = up == 0 ? 1 : -step_.overlap; right <= step_.overlap; ++right)
      if (!(Space::has_constant_gradients && up == 1 && right == 1)) step_.edge[edge++] = right + c * up;
}

template <class Space>
void KernelStep<Space>::set_material() {
  step_.lambda = body_.lame.lambda, step_.mu = body_.lame.mu, step_.density = body_.density;
  step_.rate = body_.law == exchange::Law::rate && !body_.jaumann;
  step_.hyperelastic = body_.law != exchange::Law::rate;
}

template <class Space>
void KernelStep<Space>::allocate_nodes() {
  const Size columns = size_of(step_.node_columns), overlap = size_of(step_.overlap);
  const Size margin = rounded_up(overlap * (columns + 1) + lanes, lanes);
  const Size n = size_of(step_.rows + step_.overlap) * columns, padded = n + 2 * margin;
  step_.n_node_arrays = kernel::node_matrix + 1 + phases_.n_edges;
  for (int k = 0; k < step_.n_node_arrays; ++k) {
    if (k == kernel::node_external + 1) continue; // until points have a force
    nodes_[size_of(k)].assign(padded, 0.0);
    step_.node[k] = nodes_[size_of(k)].data() + margin;
  }
  overlap_nodes_.assign(size_of(step_.n_strips * step_.n_node_arrays) * overlap * columns, 0.0);
  step_.overlap_nodes = overlap_nodes_.data();
  if (step_.full_cells && phases_.n_means > 0) {
    step_.mean_stride = padded;
    mean_.assign(size_of(phases_.n_means) * padded, 0.0);
    step_.mean = mean_.data() + margin;
  }
  held_.assign(n, 0);
  for (Size i = 0; i < n; ++i)
    for (Size d = 0; d < dim; ++d)
      held_[i] |= static_cast<std::uint8_t>(body_.fixed[i][d] ? 1U << d : 0U);
  step_.held = held_.data();
  column_volume_.assign(size_of(step_.n_strips * step_.columns), 0.0);
  step_.column_volume = column_volume_.data();
}

template <class Space>
void KernelStep<Space>::allocate_scratch() {
  const Size columns = size_of(step_.node_columns), overlap = size_of(step_.overlap), rows = size_of(step_.strip_rows);
  step_.margin = rounded_up(overlap * (columns + 1) + lanes, lanes);
  step_.stride = rounded_up(rows * columns + 2 * step_.margin, 64) + lanes; // no two quantities in one set of a cache
  step_.n_nodes = rounded_up((rows + overlap) * columns, lanes) + lanes;
  const Size block = rounded_up(size_of(phases_.block), lanes), cells = size_of(phases_.quantities) * step_.stride;
  const Size nodes = size_of(step_.n_node_arrays) * step_.n_nodes;
  for (Size thread = scratch_.size(); thread < size_of(crew_.size()); ++thread) {
    scratch_.emplace_back(block + cells + nodes + lanes, 0.0);
    double* first = aligned(scratch_.back());
    scratch_of_.push_back({.block = first, .cells = first + block, .nodes = first + block + cells});
  }
}

/// What follows from where the points are; to be called after they have been sorted.
template <class Space>
void KernelStep<Space>::take_stock() {
  sorts_ = body_.cells.sorts;
  const auto row_begin = [&](int row) {
    return body_.cells.begin[size_of(Space::cells_per_square) * size_of(step_.columns) * size_of(row)];
  };
  std::vector<Size> weights(size_of(step_.n_strips) + 1, 0);
  for (int strip = 0; strip < step_.n_strips; ++strip) {
    const Size s = size_of(strip), first = row_begin(strip * step_.strip_rows),
               last = row_begin(std::min(step_.rows, (strip + 1) * step_.strip_rows));
    weights[s] = last - first;
    touched_[s] = 0;
    for (Size p = first; p < last; ++p)
      note(s, body_.points.layer[p]);
  }
  const auto useful = static_cast<int>(std::max<Size>(1, body_.points.size() / points_per_thread));
  crew_.divide(weights, std::min(threads_, useful));
  allocate_scratch();
  point_to_points();
}

/// A point of this layer is in the strip.
template <class Space>
void KernelStep<Space>::note(Size strip, std::int32_t layer) {
  Layers& layers = layers_[strip];
  if (touched_[strip] == 0) layers = {layer, layer};
  touched_[strip] = 1;
  layers = {std::min(layers.lowest, layer), std::max(layers.highest, layer)};
}

template <class Space>
void KernelStep<Space>::point_to_points() {
  auto& points = body_.points;
  step_.points = {
      .mass = points.mass.data(),
      .volume = points.volume.data(),
      .position = {points.position[0].data(), points.position[1].data()},
      .velocity = {points.velocity[0].data(), points.velocity[1].data()},
      .stress = {points.stress[0].data(), points.stress[1].data(), points.stress[2].data(), points.stress[3].data()},
      .layer = points.layer.data(),
      .force = {nullptr, nullptr}};
  step_.begin = body_.cells.begin.data();
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
    if (gravity.besides) weight_[s].kind = kernel::Weight::with_force;
  }
  if (gravity.besides) find_force(gravity);
}

template <class Space>
void KernelStep<Space>::find_force(const Gravity& gravity) {
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
  const auto external = size_of(kernel::node_external + 1);
  if (!nodes_[external].empty()) return;
  nodes_[external].assign(nodes_[kernel::node_mass].size(), 0.0);
  step_.node[external] = nodes_[external].data() + (step_.node[kernel::node_mass] - nodes_[kernel::node_mass].data());
}

/// Nodes carry something where their strip or the one below holds points; others are cleared once.
template <class Space>
void KernelStep<Space>::activate_strips() {
  for (int strip = 0; strip <= step_.n_strips; ++strip) {
    const Size s = size_of(strip);
    const bool active = (strip < step_.n_strips && touched_[s] != 0) || (strip > 0 && touched_[s - 1] != 0);
    if (active_[s] != 0 && !active) {
      const Size columns = size_of(step_.node_columns);
      const Size first =
          size_of(std::min(step_.rows, strip * step_.strip_rows)) * columns; // the last strip may be short
      const int end =
          strip == step_.n_strips ? step_.rows + step_.overlap : std::min(step_.rows, (strip + 1) * step_.strip_rows);
      for (int k = 0; k < step_.n_node_arrays; ++k)
        if (step_.node[k] != nullptr) std::fill(step_.node[k] + first, step_.node[k] + size_of(end) * columns, 0.0);
    }
    active_[s] = active ? 1 : 0;
  }
}

template <class Space>
void KernelStep<Space>::scatter(const Gravity& gravity) {
  if (sorts_ != body_.cells.sorts) take_stock();
  set_gravity(gravity);
  activate_strips();
  for (Size s = 0; s < strays_.size(); ++s)
    stray_arrays_[s] = strays_[s].arrays();
  crew_.run([&](int strip, int thread) {
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
    height = body_.space.origin()[1] + height / body_.space.size();
  return heights;
}

template <class Space>
ForceSums KernelStep<Space>::accelerate(double damping) {
  step_.damping = damping;
  crew_.run([&](int strip, int) {
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
  crew_.run([&](int strip, int) {
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
  crew_.run([&](int strip, int thread) {
    if (strip < step_.n_strips && touched_[size_of(strip)] != 0)
      phases_.move(step_, strip, scratch_of_[size_of(thread)]);
  });
  sort_out_crossings();
  if (body_.average_stress) replace_stress_by_cell_average(body_);
}

template <class Space>
void KernelStep<Space>::gather() {
  if (n_strays_ > 0) {
    for (StripStrays& strays : strays_)
      strays.bring_home(body_.points);
    n_strays_ = 0;
    body_.sort();
  }
  if (sorts_ != body_.cells.sorts) take_stock();
}

/// Other laws, forces by point and averages are told of points by their place; there points are sorted at once.
template <class Space>
bool KernelStep<Space>::may_stray() const {
  return step_.rate && !body_.average_stress && step_.points.force[0] == nullptr;
}

template <class Space>
void KernelStep<Space>::sort_out_crossings() {
  bool sort = false;
  for (int strip = 0; strip < step_.n_strips; ++strip) {
    auto& crossings = crossings_[size_of(strip)];
    for (auto crossing = crossings.rbegin(); crossing != crossings.rend(); ++crossing) // strays from the last one on
      if (crossing->stray)
        move_stray(strip, crossing->index);
      else if (may_stray())
        n_strays_ += take_stray(crossing->index) ? 1U : 0U;
      else
        sort = true;
    crossings.clear();
  }
  if (sort) body_.sort(), take_stock();
  const Size most = body_.points.size() / most_stray_share + least_strays;
  if (n_strays_ > most) gather();
}

template <class Space>
int KernelStep<Space>::locate(const Vector<dim>& x, Size p) const {
  const int cell = body_.space.locate(x);
  if (cell < 0) throw PointLost(body_.points.id[p], x, body_.space.box());
  return cell;
}

/// Takes a point that has left its cell out of the points; false if there is none any more, only its place.
template <class Space>
bool KernelStep<Space>::take_stray(Size p) {
  auto& points = body_.points;
  const bool is_empty = points.volume[p] == 0.0 && points.mass[p] == 0.0;
  if (!is_empty) {
    const int cell = locate(points.position_of(p), p);
    const Size strip = size_of(strip_of_cell(cell));
    strays_[strip].take(points, p, cell);
    note(strip, points.layer[p]);
  }
  const Vector<dim> centre = centre_of(points.cell[p]);
  for (Size d = 0; d < dim; ++d)
    points.position[d][p] = centre[static_cast<Eigen::Index>(d)];
  return !is_empty;
}

template <class Space>
void KernelStep<Space>::move_stray(int strip, Size i) {
  StripStrays& strays = strays_[size_of(strip)];
  const Size home = strays.home(i);
  const int cell = locate(strays.position_of(i), home), new_strip = strip_of_cell(cell);
  if (new_strip == strip) return strays.set_cell(i, cell);
  strays.hand_to(strays_[size_of(new_strip)], i, cell);
  note(size_of(new_strip), body_.points.layer[home]);
}

template <class Space>
auto KernelStep<Space>::centre_of(int cell) const -> Vector<dim> {
  const auto average = body_.space.cell_average(cell);
  Vector<dim> centre = Vector<dim>::Zero();
  for (int i = 0; i < average.size(); ++i)
    centre += average.value(i) * body_.space.node_position(average.node(i));
  return centre;
}

template <class Space>
void KernelStep<Space>::crossed(void* context, int strip, bool stray, Size index) {
  static_cast<KernelStep*>(context)->crossings_[size_of(strip)].push_back({index, stray});
}

template <class Space>
void KernelStep<Space>::deform(void* context, Size first, int count, const double* gradient, Size stride) {
  for (Size q = 0; q < size_of(count); ++q) {
    Tensor<dim> g;
    g << gradient[q], gradient[stride + q], gradient[2 * stride + q], gradient[3 * stride + q];
    deform_points(static_cast<KernelStep*>(context)->body_, {first + q, first + q + 1}, IncrementalKinematics<dim>(g),
                  StrainMeasure::midpoint);
  }
}

template <class Space>
auto KernelStep<Space>::node(int node) const -> NodeState<dim> {
  const int row = node / step_.node_columns, strip = std::min(row / step_.strip_rows, step_.n_strips);
  const int own_strip = row >= step_.rows ? step_.n_strips : strip;
  const int row_of_strip = row - (own_strip == step_.n_strips ? step_.rows : own_strip * step_.strip_rows);
  const auto value = [&](int k) {
    if (step_.node[k] == nullptr) return 0.0;
    const double own = step_.node[k][node];
    if (nodes_complete_) return own;
    const Size columns = size_of(step_.node_columns);
    double sum = own_strip < step_.n_strips && touched_[size_of(own_strip)] != 0 ? own : 0.0;
    if (own_strip > 0 && row_of_strip < step_.overlap && touched_[size_of(own_strip) - 1] != 0)
      sum += overlap_nodes_[(size_of((own_strip - 1) * step_.n_node_arrays + k) * size_of(step_.overlap) +
                             size_of(row_of_strip)) *
                                columns +
                            size_of(node % step_.node_columns)];
    return sum;
  };
  NodeState<dim> state{.mass = value(kernel::node_mass)};
  for (int d = 0; d < dim; ++d) {
    const double momentum = value(kernel::node_momentum + d), force = value(kernel::node_force + d);
    state.momentum[d] = state.displacement[d] = momentum;
    state.internal[d] = state.acceleration[d] = force;
    state.external[d] = value(kernel::node_external + dim - 1 - d);
  }
  return state;
}

template <class Space>
void KernelStep<Space>::set_displacement(int node, const Vector<dim>& displacement) {
  nodes_complete_ = true;
  for (int d = 0; d < dim; ++d)
    step_.node[kernel::node_momentum + d][node] = displacement[d];
}

template class KernelStep<TriangleSpace>;
template class KernelStep<QuadrilateralSpace>;
template class KernelStep<BSplineSpace<2>>;

} // namespace settle::mpm
