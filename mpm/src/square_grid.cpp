#include "settle/mpm/square_grid.hpp"

#include <fmt/format.h>

namespace settle::mpm {

PointLost::PointLost(std::uint64_t id, const Vector<2>& position, const GridBox& box)
    : exchange::Error(
          exchange::ExitCode::solver_failed,
          exchange::to_text({.where = fmt::format("material point {}", id),
                             .what = "has left the background grid",
                             .given = fmt::format("position ({:g}, {:g}) m", position[0], position[1]),
                             .allowed = fmt::format("[{:g}, {:g}] x [{:g}, {:g}] m", box.origin[0],
                                                    box.origin[0] + box.columns * box.size, box.origin[1],
                                                    box.origin[1] + box.rows * box.size),
                             .remedy = "take a smaller mpm.explicit.courant or more mpm.quasi_static.increments"})) {}

} // namespace settle::mpm
