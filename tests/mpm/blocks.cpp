#include "blocks.hpp"

#include <algorithm>

namespace settle::mpm::test {

namespace {

template <class Space>
PointLayout<Space::dim> layout_of() {
  if constexpr (std::is_same_v<Space, TriangleSpace>)
    return triangle_layout();
  else if constexpr (std::is_same_v<Space, TetrahedronSpace>)
    return tetrahedron_layout();
  else
    return lattice_layout<Space::dim>(2);
}

} // namespace

template <class Space>
Body<Space> block(const Block& data) {
  GridBox<Space::dim> box{.counts = {}, .size = data.size};
  box.counts.fill(data.deep);
  box.counts.front() = data.columns, box.counts.back() = data.rows;
  const Space space(box);
  Body<Space> body{.space = space,
                   .points = {},
                   .layout = layout_of<Space>(),
                   .cells = {},
                   .fixed = oedometer_supports(space),
                   .lame = Lame::from(400e3, 0.25),
                   .density = block_density};
  body.points.has_domains = Space::has_domains;
  if (!data.supported) std::fill(body.fixed.begin(), body.fixed.end(), PerAxis<bool, Space::dim>{});
  place_layer(body, {.layer = 1, .base = 0.0, .thickness = data.filled_rows * data.size});
  body.sort();
  return body;
}

template <class Space>
void scatter_positions(Body<Space>& body, std::mt19937& random, double share) {
  std::uniform_real_distribution<double> shift(-share * body.space.size(), share * body.space.size());
  auto& position = body.points.position;
  const double top = *std::max_element(position.back().begin(), position.back().end());
  const double margin = 1e-3 * body.space.size();
  for (std::size_t p = 0; p < body.points.size(); ++p)
    for (std::size_t d = 0; d < position.size(); ++d) {
      const bool vertical = d + 1 == position.size();
      const double highest = vertical ? top : body.space.extent(static_cast<int>(d)) - margin;
      position[d][p] = std::clamp(position[d][p] + shift(random), margin, highest);
    }
  body.sort();
}

template <class Space>
void randomize_velocities(Body<Space>& body, std::mt19937& random) {
  std::uniform_real_distribution<double> velocity(-1.0, 1.0);
  for (auto& component : body.points.velocity)
    for (double& value : component)
      value = velocity(random);
}

template <class Space>
void randomize_stresses(Body<Space>& body, std::mt19937& random) {
  std::uniform_real_distribution<double> stress(-1e3, 1e3);
  for (auto& component : body.points.stress)
    for (double& value : component)
      value = stress(random);
}

template <int dim>
Vector<dim> total_momentum(const Points<dim>& points) {
  Vector<dim> momentum = Vector<dim>::Zero();
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t d = 0; d < dim; ++d)
      momentum[static_cast<int>(d)] += points.mass[p] * points.velocity[d][p];
  return momentum;
}

template Vector<2> total_momentum(const Points<2>&);
template Vector<3> total_momentum(const Points<3>&);

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template Body<Space> block(const Block&);                                                                            \
  template void scatter_positions(Body<Space>&, std::mt19937&, double);                                                \
  template void randomize_velocities(Body<Space>&, std::mt19937&);                                                     \
  template void randomize_stresses(Body<Space>&, std::mt19937&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm::test
