#include "settle/mpm/triangle_space.hpp"

namespace settle::mpm {

TriangleSpace::TriangleSpace(const GridBox<2>& box) : CornerNodes<2>(box) {
  gradients_[0] << -1.0, 1.0, 0.0, -1.0, 0.0, 1.0;
  gradients_[0] *= inverse_size();
  gradients_[1] = -gradients_[0];
}

} // namespace settle::mpm
