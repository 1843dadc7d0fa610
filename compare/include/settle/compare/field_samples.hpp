/// \file
/// One field of a result at the material points of one stage: a number, a vector or a tensor at each.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "settle/compare/exact_column.hpp"
#include "settle/compare/outcome.hpp"
#include "settle/exchange/result.hpp"

namespace settle::compare {

/// What happened to a material point.
struct MaterialState {
  std::array<double, 3> displacement{}; ///< since placement; two components in 2-D [m]
  std::array<double, 6> stress{};       ///< Cauchy, xx yy zz xy yz xz, tension positive [Pa]
  double plastic_strain = std::numeric_limits<double>::quiet_NaN(); ///< accumulated; NaN where nothing is known [-]
};

/// n samples of c components. Settlement [m] positive downwards, stress [Pa] tension positive.
struct FieldSamples {
  std::vector<int> layer{};     ///< (n)
  std::vector<double> x{};      ///< (n) [m]: as placed for points, in the design geometry for probes; 0 for tables
  std::vector<double> y{};      ///< (n) [m]: likewise along y in 3-D; 0 in the plane and for tables
  std::vector<double> height{}; ///< (n) [m]: placed height for points and tables, design height for probes
  std::vector<double> value{};  ///< (n, c)
  std::vector<double> weight{}; ///< (n) current volume; 1 for probes

  [[nodiscard]] std::size_t size() const { return weight.size(); }
  [[nodiscard]] std::size_t components() const { return size() > 0 ? value.size() / size() : 0; }
  void add(const FieldSamples& other, std::size_t i);
};

/// The fields by which a case is known where it names none: settlement and vertical stress of a column, displacement
/// and stress of a body of polygons.
std::vector<exchange::Quantity> usual_fields(const exchange::Case& study);

/// Appends the components of a field: one, `dimension` of a displacement, 4 (2-D: xx yy zz xy) or 6 of a stress. Its
/// shear components are multiplied by sqrt(2), so that the Euclidean norm of the components is that of the tensor.
/// Shear stress is that of the section: xy in the plane, xz in 3-D.
void append_field(const MaterialState& state, int dimension, exchange::Quantity quantity, std::vector<double>& values);

/// Does the quantity have a value at every point (displacement, stress), or for each stage (density, reactions, mass)?
bool is_field(exchange::Quantity quantity);

/// The native points of a stage, refilled ones left out.
FieldSamples point_samples(const exchange::Stage& stage, int dimension, exchange::Quantity quantity);
/// One line of probes.
FieldSamples line_samples(const exchange::ProbeSamples& line, int dimension, exchange::Quantity quantity);
/// All probe lines of a stage, in the order of their names.
FieldSamples probe_samples(const exchange::Stage& stage, int dimension, exchange::Quantity quantity);
/// The rows of a table at one stage.
FieldSamples table_samples(const ReferenceTable& table, int stage, exchange::Quantity quantity);

/// A field of one component, or the density, of a state of the exact column; NaN for anything else.
double value_of(const ColumnState& state, exchange::Quantity quantity);

/// Samples of one layer at one height (closer than `tolerance` [m]) become one: values by weight, weights added.
/// Ordered by layer and height.
FieldSamples averaged_by_height(const FieldSamples& samples, double tolerance);

} // namespace settle::compare
