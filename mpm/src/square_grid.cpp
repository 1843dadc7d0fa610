#include "settle/mpm/square_grid.hpp"

#include <fmt/format.h>

namespace settle::mpm {

namespace {

/// "a, b" or "[a, b] x [c, d]": one part for each axis.
template <int dim, class Part>
std::string joined(const char* separator, Part&& part) {
  std::string text = part(0);
  for (int d = 1; d < dim; ++d)
    text += separator + part(d);
  return text;
}

} // namespace

template <int dim>
PointLost::PointLost(std::uint64_t id, const Vector<dim>& position, const GridBox<dim>& box)
    : exchange::Error(
          exchange::ExitCode::solver_failed,
          exchange::to_text(
              {.where = fmt::format("material point {}", id),
               .what = "has left the background grid",
               .given = fmt::format("position ({}) m",
                                    joined<dim>(", ", [&](int d) { return fmt::format("{:g}", position[d]); })),
               .allowed = joined<dim>(" x ",
                                      [&](int d) {
                                        const int count = box.counts[static_cast<std::size_t>(d)];
                                        return fmt::format("[{:g}, {:g}]", box.origin[d],
                                                           box.origin[d] + count * box.size);
                                      }) +
                          " m",
               .remedy = "take a smaller mpm.explicit.courant or more mpm.quasi_static.increments"})) {}

template PointLost::PointLost(std::uint64_t, const Vector<2>&, const GridBox<2>&);
template PointLost::PointLost(std::uint64_t, const Vector<3>&, const GridBox<3>&);

} // namespace settle::mpm
