#include "blocks.hpp"

#include <algorithm>

namespace settle::mpm::test {

namespace {

template <class Space>
PointLayout layout_of() {
  if constexpr (std::is_same_v<Space, TriangleSpace>) return triangle_layout();
  return lattice_layout(2);
}

} // namespace

template <class Space>
Body<Space> block(const Block& data) {
  const Space space(GridBox{.columns = data.columns, .rows = data.rows, .size = data.size});
  Body<Space> body{.space = space,
                   .points = {},
                   .layout = layout_of<Space>(),
                   .cells = {},
                   .fixed = oedometer_supports(space),
                   .lame = Lame::from(400e3, 0.25),
                   .density = block_density};
  body.points.has_domains = Space::has_domains;
  if (!data.supported) std::fill(body.fixed.begin(), body.fixed.end(), std::array<bool, 2>{false, false});
  place_layer(body, {.layer = 1, .base = 0.0, .thickness = data.filled_rows * data.size});
  body.sort();
  return body;
}

template <class Space>
void scatter_positions(Body<Space>& body, std::mt19937& random, double share) {
  std::uniform_real_distribution<double> shift(-share * body.space.size(), share * body.space.size());
  auto& [x, y] = body.points.position;
  const double top = *std::max_element(y.begin(), y.end());
  const double margin = 1e-3 * body.space.size();
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    x[p] = std::clamp(x[p] + shift(random), margin, body.space.width() - margin);
    y[p] = std::clamp(y[p] + shift(random), margin, top);
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

Vector<2> total_momentum(const Points<2>& points) {
  Vector<2> momentum = Vector<2>::Zero();
  for (std::size_t p = 0; p < points.size(); ++p)
    momentum += points.mass[p] * Vector<2>(points.velocity[0][p], points.velocity[1][p]);
  return momentum;
}

#define SETTLE_INSTANTIATE(Space)                                                                                      \
  template Body<Space> block(const Block&);                                                                            \
  template void scatter_positions(Body<Space>&, std::mt19937&, double);                                                \
  template void randomize_velocities(Body<Space>&, std::mt19937&);                                                     \
  template void randomize_stresses(Body<Space>&, std::mt19937&);
SETTLE_FOR_EVERY_SPACE(SETTLE_INSTANTIATE)

} // namespace settle::mpm::test
