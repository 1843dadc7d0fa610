/// \file
/// Refill: keeping the surface at the design level while a layer settles.
#pragma once

#include <optional>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/mpm/body.hpp"
#include "settle/mpm/design_column.hpp"

namespace settle::mpm {

/// How the layer under construction is refilled.
struct Refill {
  std::optional<exchange::RefillRule> rule; ///< nothing: not at all
  int layer = 1;
  double lower_level = 0;  ///< design level of the layer's lower side [m]
  double design_level = 0; ///< of its surface [m]
  bool ends_closed = true; ///< the stage ends with `close_gap`
  /// Of what is drawn, instead of levels: what is designed over every column of squares, up to this stage.
  std::vector<DesignColumn> columns{};
};

/// Adds what has become due, in the state the body is in; to be called after every increment or step.
/// `element` (Aviles & Pinyol 2023): every cell of the layer that has become empty gets its initial points.
/// `sub-element`: rows of points on the surface of every column of squares, as many as fit below the design level;
/// where nothing closes the gap in the end, one as soon as the gap exceeds half its height, so that the deficit has no
/// bias. Over what is drawn, rows are parallel to the designed surface, and nothing is missing where none of it is.
/// Sorts the body if anything was added. Returns the points added.
template <class Space>
int refill_where_due(Body<Space>& body, const Refill& refill);

/// Can `refill_where_due` have something to add to a level layer? By the surfaces of the columns of squares, without
/// the points.
template <class Space>
bool refill_may_be_due(const Body<Space>& body, const Refill& refill, const std::vector<double>& heights);

/// Ends a stage once gravity is full: `sub-element` closes every gap exactly, by whole rows and one partial row (the
/// column below yields a little under it, so this is repeated after each new equilibrium); `element` as
/// `refill_where_due`. Sorts the body if anything was added. Returns the points added; 0 when no gap is worth closing.
template <class Space>
int close_gap(Body<Space>& body, const Refill& refill);

} // namespace settle::mpm
