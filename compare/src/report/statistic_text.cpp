#include "statistic_text.hpp"

#include <cmath>

#include <fmt/format.h>

#include "format.hpp"

namespace settle::compare::report {

StatisticForm form_of(Statistic statistic) {
  switch (statistic) {
  case Statistic::max_settlement:
    return {"largest settlement", "m", 1.0};
  case Statistic::max_vertical_stress:
    return {"largest vertical stress", "kPa", 1e-3};
  case Statistic::mean_density:
    return {"mean density", "kg/m³", 1.0};
  case Statistic::base_reaction_stress:
    return {"base reaction over area", "kPa", 1e-3};
  case Statistic::refilled_points:
    return {"refilled points", "", 1.0};
  }
  return {};
}

std::string value_text(Statistic statistic, double value, int significant) {
  if (statistic == Statistic::refilled_points && std::isfinite(value)) return fmt::format("{:.0f}", value);
  return number(form_of(statistic).factor * value, significant);
}

std::string difference_text(Statistic statistic, double value, double reference) {
  if (statistic != Statistic::refilled_points) return difference(value, reference);
  const double more = value - reference;
  if (!std::isfinite(more)) return std::string(no_value);
  return fmt::format("{}{:.0f}", more > 0 ? "+" : more < 0 ? "−" : "", std::abs(more));
}

} // namespace settle::compare::report
