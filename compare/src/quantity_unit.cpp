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
  case Quantity::thrust:
    return "N/m";
  case Quantity::mass:
    return "kg/m";
  case Quantity::plastic_strain:
    return "";
  }
  return "";
}

} // namespace

std::string unit_of(Quantity quantity, int dimension) {
  const std::string unit = unit_of(quantity);
  const bool per_length = unit == "N/m" || unit == "kg/m";
  return dimension == 3 && per_length ? unit.substr(0, unit.find('/')) : unit;
}

} // namespace settle::compare
