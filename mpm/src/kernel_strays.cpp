// Points that leave their cell: kept apart as strays, or sorted.

#include "kernel_step.hpp"

namespace settle::mpm {

namespace {

constexpr int most_stray_share = 16; ///< points are sorted once more than 1/16 of them have strayed
constexpr int least_strays = 8;      ///< or more than these, in small bodies

} // namespace

template <class Space>
void KernelStep<Space>::gather() {
  if (n_strays_ > 0) {
    for (auto& strays : strays_)
      strays.bring_home(body_.points);
    n_strays_ = 0;
    sort_by_known_cells();
  }
  if (sorts_ != body_.cells.sorts) take_stock();
}

/// All other points are still where they were sorted to.
template <class Space>
void KernelStep<Space>::sort_by_known_cells() {
  const auto order = order_by_cell(body_.points.cell, size_of(body_.space.n_cells()), body_.cells);
  crew_.run(equal_shares(Points<dim>::n_arrays, shares_.threads()),
            [&](int array, int) { body_.points.permute_array(array, order); });
  ++body_.cells.sorts;
}

/// Other laws, forces by point and averages are told of points by their place; there points are sorted at once.
template <class Space>
bool KernelStep<Space>::may_stray() const {
  return step_.rate && !body_.average_stress && step_.points.force[0] == nullptr;
}

template <class Space>
void KernelStep<Space>::sort_out_crossings() {
  bool sort = false;
  for (Size tile = 0; tile < crossings_.size(); ++tile) {
    auto& crossings = crossings_[tile];
    for (auto crossing = crossings.rbegin(); crossing != crossings.rend(); ++crossing) // strays from the last one on
      if (crossing->stray)
        move_stray(tile, crossing->index);
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
    const Size tile = tile_of(cell);
    strays_[tile].take(points, p, cell);
    note(strip_of(tile), points.layer[p]);
  }
  const Vector<dim> centre = centre_of(points.cell[p]);
  for (Size d = 0; d < dim; ++d)
    points.position[d][p] = centre[static_cast<Eigen::Index>(d)];
  return !is_empty;
}

template <class Space>
void KernelStep<Space>::move_stray(Size tile, Size i) {
  auto& strays = strays_[tile];
  const Size home = strays.home(i);
  const int cell = locate(strays.position_of(i), home);
  const Size new_tile = tile_of(cell);
  if (new_tile == tile) return strays.set_cell(i, cell);
  strays.hand_to(strays_[new_tile], i, cell);
  note(strip_of(new_tile), body_.points.layer[home]);
}

template <class Space>
auto KernelStep<Space>::tile_of(int cell) const -> Size {
  const int square = cell / Space::cells_per_square, row = square / step_.columns;
  const int line = row % step_.strip_rows * step_.node_lines + square % step_.columns / step_.line;
  const int part = square % step_.line / step_.tile_width;
  return size_of(row / step_.strip_rows * step_.strip_tiles + line / step_.tile_lines * step_.line_parts + part);
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
void KernelStep<Space>::crossed(void* context, int tile, bool stray, Size index) {
  static_cast<KernelStep*>(context)->crossings_[size_of(tile)].push_back({index, stray});
}

#define SETTLE_INSTANTIATE(Space) template class KernelStep<Space>;
SETTLE_FOR_EVERY_SPACE_WITH_KERNELS(SETTLE_INSTANTIATE)

} // namespace settle::mpm
