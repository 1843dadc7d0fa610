/// \file
/// A field at the end of construction as it lies in space: what each solver says, on one scale.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "element_points.hpp"
#include "profiles.hpp"

namespace settle::compare::report {

/// What values there are, in the unit of the quantity's axis. Starts with none.
struct ValueRange {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();

  [[nodiscard]] bool empty() const { return lowest > highest; }
  void include(double value);
  void include(const ValueRange& other);
};

/// A sample point as a spot of its size.
struct Spot {
  exchange::PlanePoint at{}; ///< [m]
  double radius = 0;         ///< [m]
  double value = 0;
};

/// A part of an element.
struct Patch {
  Quadrilateral corners{}; ///< around it [m]
  double value = 0;
};

/// One solver's field where its material is now; all values finite.
struct FieldLeg {
  std::string title;
  std::string drawn; ///< "1920 material points"
  std::vector<Spot> spots;
  std::vector<Patch> patches;
  ValueRange range;
};

struct FieldPicture {
  exchange::Quantity quantity = exchange::Quantity::settlement;
  std::vector<FieldLeg> legs;
  ValueRange scale;                   ///< of all legs
  std::optional<FieldLeg> difference; ///< MPM - FEM, at MPM's points
  std::vector<std::string> missing;   ///< a sentence for whatever is not drawn
  std::vector<std::string> remarks;   ///< a sentence for whatever has to be known to read it
};

/// A run's last stage. Solvers without points of their own, points without a finite value or position, and points far
/// off are not drawn and said to be missing. In 3-D a vertical cut through the middle.
FieldPicture field_picture_of(const RunOutcome& run, exchange::Quantity quantity);

/// What a picture shows: the design geometry and all that is drawn, but nothing further from the former than half its
/// larger edge.
exchange::PlaneBox view_of(const RunOutcome& run, const FieldPicture& picture);
/// Half its larger edge around the design geometry: what is beyond has left the problem.
exchange::PlaneBox widest_view(const exchange::Case& study);

} // namespace settle::compare::report
