/// \file
/// The material points that a leg is about.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boundary_band.hpp"
#include "settle/compare/field_samples.hpp"
#include "settle/compare/legs.hpp"

namespace settle::compare {

/// Layers and region of a request, at its stage.
class LegRegion {
public:
  LegRegion(const RunOutcome& run, const LegRequest& request);

  /// Does a sample belong to it? By its place as placed, or in the design geometry.
  [[nodiscard]] bool holds(const FieldSamples& samples, std::size_t i) const;

private:
  exchange::Region region_;
  std::vector<int> layers_;          ///< first and last; empty: all
  std::optional<BoundaryBand> band_; ///< by which the region is told; none of the whole body
};

/// The width of the band along a boundary in which a leg's elements cannot be expected to be at their best: two
/// elements of the coarser of its solvers [m].
double band_width(const RunOutcome& run, const LegRequest& request);

/// Edge of the elements of a solver, by the case [m].
double element_size_of(const RunOutcome& run, const std::string& solver);

/// "in the interior", ...; empty for the whole body.
std::string text_of(exchange::Region region);

} // namespace settle::compare
