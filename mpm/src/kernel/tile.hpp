/// \file
/// Strips of rows, their tiles of lines, and the squares in them.
#pragma once

#include "lanes.hpp"

namespace settle::mpm::kernel::SETTLE_VARIANT {

/// Rows of squares first ... last - 1, and the nodes at their lowest corners.
struct Strip {
  int first_row, last_row;

  Strip(const Step& step, int strip)
      : first_row(strip * step.strip_rows), last_row(least(step.rows, first_row + step.strip_rows)) {}
  [[nodiscard]] std::size_t first_node(const Step& step) const {
    return static_cast<std::size_t>(first_row) * static_cast<std::size_t>(step.node_columns);
  }
};

/// Lines first ... last - 1 of a strip, counted from its first row on, those that do not exist included; or a part of
/// one line.
struct Tile {
  int index; ///< among the tiles of all strips
  int first_row, first_line, last_line;
  int first_column, width;  ///< of its lines, those squares that do not exist included
  int columns;              ///< that exist in a line that does
  std::size_t first_square; ///< of the strip's
  std::size_t n_squares;    ///< those that do not exist included
  std::size_t n_nodes;      ///< that its squares touch on their own line, one after the other

  Tile(const Step& step, int strip, int tile) : index(strip * step.strip_tiles + tile) {
    const Strip rows(step, strip);
    first_row = rows.first_row, first_line = tile / step.line_parts * step.tile_lines;
    last_line = least((rows.last_row - rows.first_row) * step.node_lines, first_line + step.tile_lines);
    first_column = tile % step.line_parts * step.tile_width;
    width = least(step.tile_width, step.node_line - first_column);
    columns = least(width, step.line - first_column);
    first_square = static_cast<std::size_t>(first_line) * static_cast<std::size_t>(step.node_line) +
                   static_cast<std::size_t>(first_column);
    n_squares =
        last_line > first_line ? static_cast<std::size_t>(last_line - first_line) * static_cast<std::size_t>(width) : 0;
    const int more = first_column + width < step.node_line ? step.overlap : 0;
    n_nodes = n_squares + static_cast<std::size_t>(more);
  }
  [[nodiscard]] std::size_t first_node(const Step& step) const {
    return static_cast<std::size_t>(first_row) * static_cast<std::size_t>(step.node_columns) + first_square;
  }
  /// A line counts from the strip's first row on.
  [[nodiscard]] static bool exists(const Step& step, int line) { return line % step.node_lines < step.lines; }
  /// Squares that exist before a line.
  [[nodiscard]] std::size_t squares_before(const Step& step, int line) const {
    const int rows = first_row + line / step.node_lines;
    return static_cast<std::size_t>(rows * step.lines + least(line % step.node_lines, step.lines)) *
           static_cast<std::size_t>(step.line);
  }
  /// Squares that exist before the tile's first one, and before those that follow its last one.
  [[nodiscard]] std::size_t first_number(const Step& step) const {
    return squares_before(step, first_line) + static_cast<std::size_t>(exists(step, first_line) ? first_column : 0);
  }
  [[nodiscard]] std::size_t end_number(const Step& step) const {
    if (step.line_parts == 1) return squares_before(step, last_line);
    return first_number(step) + static_cast<std::size_t>(exists(step, first_line) ? columns : 0);
  }
  [[nodiscard]] std::size_t first_point(const Step& step, int per_square) const {
    return step.begin[static_cast<std::size_t>(per_square) * first_number(step)];
  }
  [[nodiscard]] std::size_t end_of_points(const Step& step, int per_square) const {
    return step.begin[static_cast<std::size_t>(per_square) * end_number(step)];
  }
  [[nodiscard]] bool is_empty(const Step& step, int per_square) const {
    return n_squares == 0 ||
           (first_point(step, per_square) == end_of_points(step, per_square) && step.strays[index].count == 0);
  }
  /// Where a square that exists is among the tile's.
  [[nodiscard]] std::size_t place_of(const Step& step, int square) const {
    const int row = square / step.columns - first_row, in_row = square % step.columns;
    const int line = row * step.node_lines + in_row / step.line - first_line;
    return static_cast<std::size_t>(line * width + in_row % step.line - first_column);
  }
};

/// Calls `action(first, square)` for every line of a tile that exists, with the place of its first square among the
/// tile's and its number in the grid, and `skip(first)` for those that do not. A line has `tile.columns` squares.
template <class Action, class Skip>
SETTLE_INLINE void for_each_line(const Step& step, const Tile& tile, Action&& action, Skip&& skip) {
  std::size_t first = 0;
  for (int line = tile.first_line; line < tile.last_line; ++line, first += static_cast<std::size_t>(tile.width))
    if (Tile::exists(step, line))
      action(first, tile.squares_before(step, line) + static_cast<std::size_t>(tile.first_column));
    else
      skip(first);
}
template <class Action>
SETTLE_INLINE void for_each_line(const Step& step, const Tile& tile, Action&& action) {
  for_each_line(step, tile, action, [](std::size_t) {});
}

/// Calls `action(which, square, first, last)` for every cell of the tile with the range of its points.
template <int per_square, class Action>
SETTLE_INLINE void for_each_cell(const Step& step, const Tile& tile, Action&& action) {
  for_each_line(step, tile, [&](std::size_t square, std::size_t number) {
    const std::uint32_t* begin = step.begin + static_cast<std::size_t>(per_square) * number;
    for (int column = 0; column < tile.columns; ++column, ++square)
      for (int which = 0; which < per_square; ++which, ++begin)
        action(which, square, std::size_t{begin[0]}, std::size_t{begin[1]});
  });
}

/// The same for its strays, with ranges of these; not for cells without any.
template <int per_square, class Action>
SETTLE_INLINE void for_each_cell_of_strays(const Step& step, const Tile& tile, Action&& action) {
  const Strays& strays = step.strays[tile.index];
  for (std::size_t first = 0; first < strays.count;) {
    const std::int32_t cell = strays.cell[first];
    std::size_t last = first + 1;
    while (last < strays.count && strays.cell[last] == cell)
      ++last;
    action(cell % per_square, tile.place_of(step, cell / per_square), first, last);
    first = last;
  }
}

/// Where points lie: in which squares, and where in them.
template <int dim>
struct Place {
  Lanes index[dim], local[dim];
};
template <int dim>
SETTLE_INLINE Place<dim> place(const Step& step, const Lanes x[dim]) {
  Place<dim> at;
  for (int d = 0; d < dim; ++d) {
    const Lanes scaled = (x[d] - step.origin[d]) * step.inverse_size;
    at.index[d] = floor_of(scaled);
    at.local[d] = scaled - at.index[d];
  }
  return at;
}
template <int dim>
SETTLE_INLINE Mask in_other_squares(const Place<dim>& a, const Place<dim>& b) {
  Mask other{};
  for (int d = 0; d < dim; ++d)
    other |= a.index[d] != b.index[d];
  return other;
}

/// Quantity k of a square is at `quantity(k)[square]`, zero for squares before the first and after the last.
struct CellArrays {
  double* base;
  std::size_t stride;

  CellArrays(const Step& step, double* cells) : base(cells + cell_margin), stride(step.stride) {}
  SETTLE_INLINE double* quantity(int k) const { return base + static_cast<std::size_t>(k) * stride; }
  /// Those behind the first k.
  [[nodiscard]] CellArrays after(int k) const {
    CellArrays rest = *this;
    rest.base += static_cast<std::size_t>(k) * stride;
    return rest;
  }
  /// Zeroes what a longer tile has left of the first `count` quantities behind the last square of a shorter one.
  SETTLE_INLINE void clear_behind(const Step& step, const Tile& tile, int count) const {
    const std::size_t last = step.line_parts == 1 ? tile.n_squares : static_cast<std::size_t>(tile.columns);
    if (last < step.tile_squares) clear(count, last, tile.n_squares + cell_margin);
  }
  /// Zeroes the first `count` quantities of the squares first ... last - 1.
  SETTLE_INLINE void clear(int count, std::size_t first, std::size_t last) const {
    for (int k = 0; k < count; ++k)
      for (std::size_t s = first; s < last; ++s)
        quantity(k)[s] = 0.0;
  }
};

} // namespace settle::mpm::kernel::SETTLE_VARIANT
