#include "settle/mpm/tetrahedron_space.hpp"

namespace settle::mpm {

TetrahedronSpace::TetrahedronSpace(const GridBox<3>& box) : CornerNodes<3>(box) {
  for (std::size_t cell = 0; cell < orders.size(); ++cell) {
    Gradients& gradients = gradients_[cell];
    gradients.setZero();
    for (int k = 0; k < 3; ++k) { // the value of node k falls along this axis, that of the next one rises
      const int axis = orders[cell][static_cast<std::size_t>(k)];
      gradients(axis, k) -= inverse_size();
      gradients(axis, k + 1) += inverse_size();
    }
  }
}

} // namespace settle::mpm
