/// \file
/// What settle-fem says of a case that it cannot solve.
#pragma once

#include <string>

#include "settle/exchange/errors.hpp"
#include "settle/fem/requirements.hpp"

namespace settle::fem::testing {

/// The text of the InputError that a case ends in; empty if it is accepted.
inline std::string complaint_about(const exchange::Case& study) {
  try {
    require_solvable(study);
  } catch (const exchange::InputError& error) {
    return error.what();
  }
  return {};
}

} // namespace settle::fem::testing
