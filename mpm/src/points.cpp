#include "settle/mpm/points.hpp"

#include <cmath>
#include <ranges>

namespace settle::mpm {

namespace {

template <class T>
void permute_values(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  const auto permuted = order | std::views::transform([&](std::uint32_t i) -> const T& { return values[i]; });
  std::vector<T> copy(permuted.begin(), permuted.end());
  values.swap(copy);
}

} // namespace

template <int dim>
void Points<dim>::add(const NewPoint<dim>& point) {
  id.push_back(next_id++);
  cell.push_back(-1);
  layer.push_back(point.layer);
  refilled.push_back(point.refilled ? 1 : 0);
  mass.push_back(point.density * point.volume);
  volume.push_back(point.volume);
  for (int c = 0; c < dim; ++c) {
    const auto i = static_cast<std::size_t>(c);
    position[i].push_back(point.position[c]);
    placed[i].push_back(point.position[c]);
    velocity[i].push_back(0.0);
  }
  for (auto& component : stress)
    component.push_back(0.0);
  if (has_domains) {
    const double square = 0.5 * std::pow(point.volume, 1.0 / dim);
    const bool given = point.half_lengths.squaredNorm() > 0.0;
    for (int c = 0; c < dim; ++c)
      half_length[static_cast<std::size_t>(c)].push_back(given ? point.half_lengths[c] : square);
  }
  if (yields) plastic_strain.push_back(0.0);
  if (hardens) preconsolidation_pressure.push_back(point.preconsolidation_pressure);
  if (!tracks_deformation) return;
  for (auto& component : deformation)
    component.push_back(0.0);
  set_deformation(size() - 1, Tensor<dim>::Identity());
}

template <int dim>
void Points<dim>::permute_array(int array, const std::vector<std::uint32_t>& order) {
  const auto apply = [&](auto& values) {
    if (array-- == 0 && !values.empty()) permute_values(values, order); // empty: there where a law or space needs it
  };
  const auto apply_to_all = [&](auto& components) {
    for (auto& component : components)
      apply(component);
  };
  apply(id), apply(cell), apply(layer), apply(refilled), apply(mass), apply(volume);
  apply_to_all(position), apply_to_all(placed), apply_to_all(velocity), apply_to_all(stress);
  apply_to_all(half_length), apply_to_all(deformation);
  apply(plastic_strain), apply(preconsolidation_pressure);
}

template struct Points<2>;
template struct Points<3>;

} // namespace settle::mpm
