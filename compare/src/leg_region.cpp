#include "leg_region.hpp"

#include <algorithm>

#include "leg_side.hpp"

namespace settle::compare {

using exchange::Region;

namespace {

constexpr double elements = 2.0; // in the band

std::vector<BoundaryPart> parts_of(const exchange::Case& study, Region region, int stage) {
  switch (region) {
  case Region::whole:
    return {};
  case Region::interior:
  case Region::surface:
    return free_surface(study, stage);
  case Region::base:
    return base(study);
  }
  return {};
}

} // namespace

LegRegion::LegRegion(const RunOutcome& run, const LegRequest& request)
    : region_(request.region), layers_(request.layers), parts_(parts_of(run.study, request.region, request.stage)),
      band_(band_width(run, request)) {}

bool LegRegion::holds(int layer, const exchange::PlanePoint& point) const {
  if (!layers_.empty() && (layer < layers_.front() || layers_.back() < layer)) return false;
  switch (region_) {
  case Region::whole:
    return true;
  case Region::interior:
    return distance(parts_, point) > band_;
  case Region::surface:
  case Region::base:
    return distance(parts_, point) <= band_;
  }
  return false;
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
