/// \file
/// One scalar field of a result at the material points of one stage.
#pragma once

#include <string>
#include <vector>

#include "settle/compare/exact_column.hpp"
#include "settle/compare/outcome.hpp"
#include "settle/exchange/result.hpp"

namespace settle::compare {

/// n samples. Settlement [m] positive downwards, stress [Pa] tension positive.
struct FieldSamples {
  std::vector<int> layer;     ///< (n)
  std::vector<double> height; ///< (n) [m]: placed height for points and tables, design height for probes
  std::vector<double> value;  ///< (n)
  std::vector<double> weight; ///< (n) current volume; 1 for probes

  [[nodiscard]] std::size_t size() const { return value.size(); }
  void add(const FieldSamples& other, std::size_t i);
};

/// Does the quantity have a value at every point (settlement, stress), or one a stage (density, reaction, mass)?
bool is_field(exchange::Quantity quantity);

/// The native points of a stage, refilled ones left out.
FieldSamples point_samples(const exchange::Stage& stage, int dimension, exchange::Quantity quantity);
/// All probe lines of a stage, in the order of their names.
FieldSamples probe_samples(const exchange::Stage& stage, int dimension, exchange::Quantity quantity);
/// The rows of a table at one stage.
FieldSamples table_samples(const ReferenceTable& table, int stage, exchange::Quantity quantity);

/// A field of a state of the exact column.
double value_of(const ColumnState& state, exchange::Quantity quantity);

/// Samples of one layer at one height (closer than `tolerance` [m]) become one: values by weight, weights added.
/// Ordered by layer and height.
FieldSamples averaged_by_height(const FieldSamples& samples, double tolerance);

} // namespace settle::compare
