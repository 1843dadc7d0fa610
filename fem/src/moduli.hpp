/// \file
/// Moduli from what they do.
#pragma once

#include <deal.II/base/symmetric_tensor.h>

namespace settle::fem {

/// The moduli of a linear map of symmetric tensors, column by column.
template <class Map>
dealii::SymmetricTensor<4, 3> moduli_of(const Map& map) {
  dealii::SymmetricTensor<4, 3> moduli;
  for (unsigned k = 0; k < 3; ++k)
    for (unsigned l = k; l < 3; ++l) {
      dealii::SymmetricTensor<2, 3> unit;
      unit[k][l] = k == l ? 1.0 : 0.5; // the other half stands at [l][k]
      const dealii::SymmetricTensor<2, 3> column = map(unit);
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = i; j < 3; ++j)
          moduli[i][j][k][l] = column[i][j];
    }
  return moduli;
}

} // namespace settle::fem
