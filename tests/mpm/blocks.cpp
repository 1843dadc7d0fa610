#include "blocks.hpp"

#include <algorithm>

namespace settle::mpm::test {

Body<TriangleGrid> block(const Block& data) {
  const TriangleGrid grid(data.columns, data.rows, data.size);
  Body<TriangleGrid> body{.grid = grid,
                          .points = {},
                          .cells = {},
                          .fixed = oedometer_supports(grid),
                          .lame = Lame::from(400e3, 0.25),
                          .density = block_density};
  if (!data.supported) std::fill(body.fixed.begin(), body.fixed.end(), std::array<bool, 2>{false, false});
  place_layer(body, {.layer = 1, .base = 0.0, .thickness = data.filled_rows * data.size});
  body.sort();
  return body;
}

void scatter_positions(Body<TriangleGrid>& body, std::mt19937& random, double share) {
  std::uniform_real_distribution<double> shift(-share * body.grid.size(), share * body.grid.size());
  auto& [x, y] = body.points.position;
  const double top = *std::max_element(y.begin(), y.end());
  const double margin = 1e-3 * body.grid.size();
  for (std::size_t p = 0; p < body.points.size(); ++p) {
    x[p] = std::clamp(x[p] + shift(random), margin, body.grid.width() - margin);
    y[p] = std::clamp(y[p] + shift(random), margin, top);
  }
  body.sort();
}

void randomize_velocities(Body<TriangleGrid>& body, std::mt19937& random) {
  std::uniform_real_distribution<double> velocity(-1.0, 1.0);
  for (auto& component : body.points.velocity)
    for (double& value : component)
      value = velocity(random);
}

void randomize_stresses(Body<TriangleGrid>& body, std::mt19937& random) {
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

} // namespace settle::mpm::test
