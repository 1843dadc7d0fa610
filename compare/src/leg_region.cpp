#include "leg_region.hpp"

#include <algorithm>

#include "leg_side.hpp"

namespace settle::compare {

using exchange::Region;

namespace {

constexpr double elements = 2.0; // in the band

std::optional<BoundaryBand> band_of(const exchange::Case& study, Region region, int stage, double width) {
  switch (region) {
  case Region::whole:
    return {};
  case Region::interior:
  case Region::surface:
    return BoundaryBand::along_free_surface(study, stage, width);
  case Region::base:
    return BoundaryBand::along_base(study, width);
  }
  return {};
}

} // namespace

LegRegion::LegRegion(const RunOutcome& run, const LegRequest& request)
    : region_(request.region), layers_(request.layers),
      band_(band_of(run.study, request.region, request.stage, band_width(run, request))) {}

bool LegRegion::holds(const FieldSamples& samples, std::size_t i) const {
  const int layer = samples.layer[i];
  if (!layers_.empty() && (layer < layers_.front() || layers_.back() < layer)) return false;
  if (!band_) return true;
  const bool near = band_->holds({samples.x[i], samples.y[i], samples.height[i]});
  return region_ == Region::interior ? !near : near;
}

/// Of one that joins nothing is known but that it was given the case.
double element_size_of(const RunOutcome& run, const std::string& solver) {
  if (solver == "mpm") return run.study.mpm.element_size;
  if (solver == "fem") return run.study.fem.element_size;
  return std::max(run.study.mpm.element_size, run.study.fem.element_size);
}

double band_width(const RunOutcome& run, const LegRequest& request) {
  double largest = 0.0;
  for (const std::string& name : {request.value, request.reference}) {
    if (side_of(run, name) == Side::solver) largest = std::max(largest, element_size_of(run, name));
  }
  return elements * largest;
}

std::string text_of(Region region) {
  switch (region) {
  case Region::whole:
    return "";
  case Region::interior:
    return "in the interior";
  case Region::surface:
    return "along the free surface";
  case Region::base:
    return "along the base";
  }
  return "";
}

} // namespace settle::compare
