#include "settle/mpm/triangle_grid.hpp"

#include <fmt/format.h>

namespace settle::mpm {

PointLost::PointLost(std::uint64_t id, double x, double y, double width, double height)
    : exchange::Error(exchange::ExitCode::solver_failed,
                      exchange::to_text({.where = fmt::format("material point {}", id),
                                         .what = "has left the background grid",
                                         .given = fmt::format("position ({:g}, {:g}) m", x, y),
                                         .allowed = fmt::format("[0, {:g}] x [0, {:g}] m", width, height),
                                         .remedy = "take a smaller mpm.explicit.courant or more "
                                                   "mpm.quasi_static.increments"})) {}

TriangleGrid::TriangleGrid(int columns, int rows, double size)
    : columns_(columns), rows_(rows), size_(size), inverse_size_(1.0 / size) {
  gradients_[0] << -1.0, 1.0, 0.0, -1.0, 0.0, 1.0;
  gradients_[0] *= inverse_size_;
  gradients_[1] = -gradients_[0];
}

} // namespace settle::mpm
