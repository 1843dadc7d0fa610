#include "quantity_unit.hpp"

namespace settle::compare {

using exchange::Quantity;

namespace {

std::string unit_of(Quantity quantity) {
  switch (quantity) {
  case Quantity::settlement:
  case Quantity::displacement:
  case Quantity::failure_height:
    return "m";
  case Quantity::vertical_stress:
  case Quantity::lateral_stress:
  case Quantity::shear_stress:
  case Quantity::stress:
    return "Pa";
  case Quantity::density:
    return "kg/m3";
  case Quantity::base_reaction:
  case Quantity::support_reaction:
    return "N/m";
  case Quantity::mass:
    return "kg/m";
  }
  return "";
}

} // namespace

std::string unit_of(Quantity quantity, int dimension) {
  const bool is_force = quantity == Quantity::base_reaction || quantity == Quantity::support_reaction;
  if (dimension == 3 && is_force) return "N";
  if (dimension == 3 && quantity == Quantity::mass) return "kg";
  return unit_of(quantity);
}

} // namespace settle::compare
