#include "moves.hpp"

#include <algorithm>
#include <optional>

namespace settle::mpm {

template <int dim>
double largest_move(const Points<dim>& before, const Points<dim>& after) {
  std::vector<std::optional<Vector<dim>>> place(std::max(before.next_id, after.next_id));
  for (std::size_t p = 0; p < before.size(); ++p)
    place[before.id[p]] = before.position_of(p);
  double largest = 0;
  for (std::size_t p = 0; p < after.size(); ++p)
    if (const auto& from = place[after.id[p]]) largest = std::max(largest, (after.position_of(p) - *from).norm());
  return largest;
}

template <int dim>
double reach_beyond(const Points<dim>& before, const Points<dim>& after) {
  const auto [left, right] = std::minmax_element(before.position[0].begin(), before.position[0].end());
  const auto [new_left, new_right] = std::minmax_element(after.position[0].begin(), after.position[0].end());
  return std::max({0.0, *left - *new_left, *new_right - *right});
}

template <int dim>
double kinetic_energy(const Points<dim>& points) {
  double energy = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    for (const auto& component : points.velocity)
      energy += 0.5 * points.mass[p] * component[p] * component[p];
  return energy;
}

#define SETTLE_INSTANTIATE(dim)                                                                                        \
  template double largest_move(const Points<dim>&, const Points<dim>&);                                                \
  template double reach_beyond(const Points<dim>&, const Points<dim>&);                                                \
  template double kinetic_energy(const Points<dim>&);
SETTLE_INSTANTIATE(2)
SETTLE_INSTANTIATE(3)

} // namespace settle::mpm
