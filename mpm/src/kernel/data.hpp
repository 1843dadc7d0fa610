/// \file
/// What the kernels of the explicit step work on: plain pointers and numbers. The kernels are compiled once for every
/// instruction set, so what they share with other code holds no function that a linker could take from the wrong one.
#pragma once

#include <cstddef>
#include <cstdint>

namespace settle::mpm::kernel {

/// Arrays of points. In the plane the third axis has none.
struct PointArrays {
  const double* mass;
  double* volume;
  double* position[3];
  double* velocity[3];
  double* stress[6]; ///< xx yy zz xy, in 3-D yz xz besides
  const std::int32_t* layer;
  const double* force[2]; ///< per mass, besides gravity [m/s2], in the plane; null: none
};

/// Points in a tile that have left the range of their cell since the points were sorted; in any order.
struct Strays {
  PointArrays points;
  const std::int32_t* cell;
  std::size_t count;
};

/// Arrays over the nodes, with zeros before the first and after the last, as far as edges reach. Of each vector come
/// the components along x, y ..., of the external force those along the last axis first: those along the others are
/// only there where points have a force besides gravity.
template <int dim>
struct NodeArrays {
  static constexpr int mass = 0;             ///< lumped
  static constexpr int momentum = 1;         ///< once moved: displacement in the step
  static constexpr int force = 1 + dim;      ///< internal; once accelerated: acceleration
  static constexpr int pull = 1 + 2 * dim;   ///< external, along the last axis
  static constexpr int matrix = 1 + 3 * dim; ///< consistent mass: diagonal, then the couplings with node + edge
  static constexpr int external(int axis) { return pull + dim - 1 - axis; }
};
inline constexpr int max_edges = 62;
inline constexpr int max_node_arrays = NodeArrays<3>::matrix + 1 + max_edges;

/// From a node to those that it couples with, by axis; of a coupling's two nodes the one with the smaller number first.
struct Edges {
  int count;
  int by_axis[max_edges][3];
};

/// Numbers of a strip of rows of squares. A strip's sums do not depend on the thread that works on it.
struct StripSums {
  double slowness_squared; ///< least of its cells, density over stiffness [s2/m2]
  double unbalanced, external, base_reaction;
  double kinetic, external_work;
};

/// How a strip's points are pulled down.
enum class Weight {
  uniform,   ///< all by the same gravity
  by_layer,  ///< by the gravity of their layers
  with_force ///< the same, and by their force besides; in the plane
};
struct StripWeight {
  Weight kind;
  double gravity; ///< where uniform [m/s2]
};

/// Memory of one thread.
struct Scratch {
  double* block; ///< quantities of a block of points
  double* cells; ///< quantities of the squares of a tile
};

/// Before the first square of a tile, and after the last, so many zeros can be read.
inline constexpr std::size_t cell_margin = 16;

/// A step. Squares (in 3-D cubes) lie in lines along x, lines in rows: a row is all that lies at one height. Rows are
/// taken in strips, the lines of a strip, or parts of long ones, in tiles. Squares are numbered like the node at their
/// lowest corner, so that each line ends with squares, and in 3-D each row with lines of squares, that do not exist and
/// hold nothing: whatever goes from cells to nodes or back is then a loop over one index.
struct Step {
  int line, lines, rows;     ///< squares of a line, lines of a row (1 in the plane), rows
  int columns;               ///< squares of a row
  int node_line, node_lines; ///< the same with those that do not exist
  int node_columns;          ///< of a row
  int node_step[3];          ///< from a node to the next along each axis
  int overlap;               ///< rows of nodes that a square touches besides its own
  int strip_rows;            ///< rows of squares in a strip
  int n_strips;              ///< of squares; nodes have one more, which owns the uppermost rows
  int tile_lines;            ///< in a tile, those that do not exist included
  int line_parts;            ///< tiles that a line is cut into where it is too long for one; else 1
  int tile_width;            ///< squares of a line, or of a part of it, those that do not exist included
  std::size_t tile_squares;  ///< of the largest tile
  int strip_tiles;           ///< tiles in a strip
  std::size_t stride;        ///< from one quantity to the next in Scratch::cells
  std::size_t last_touched;  ///< from a square's own node to the last one that it touches
  double origin[3];          ///< [m]
  double inverse_size;       ///< [1/m]
  double cell_volume;        ///< [m3/m]
  bool full_cells;           ///< mixed integration
  double lambda, mu;         ///< [Pa]
  double density;            ///< as placed [kg/m3]
  bool rate;                 ///< the law `rate` without rotation; other laws come in through `deform`
  bool hyperelastic;         ///< stiffness follows density and stress
  double gravity;            ///< [m/s2]
  double ramped_gravity;     ///< of the layer under construction
  int ramped_layer;
  double damping, kick, dt; ///< dt: of positions and strains; kick: of velocities [s]
  double kept;              ///< of velocities after they have changed [-]

  PointArrays points;
  const std::uint32_t* begin; ///< by cell
  const Strays* strays;       ///< by tile

  double* node[max_node_arrays]; ///< null: none
  double* overlap_nodes;         ///< by strip, array, node: what it adds to the nodes of the next one
  std::size_t overlap_stride;    ///< from one array to the next there
  int n_node_arrays;
  int edge[max_edges];         ///< from a node to the one it couples with
  const std::uint8_t* held;    ///< by node: 1: x, 2: y, 4: z
  const std::uint8_t* touched; ///< by strip: does it hold points?
  double* mean;                ///< by function, square: its mean over the points, in products (axis.hpp); null: none
  std::size_t mean_stride;
  double* column_volume;     ///< by strip, column [m3/m]
  const StripWeight* weight; ///< by strip
  StripSums* sums;           ///< by strip of nodes

  void* context;
  /// A point of the tile, or a stray, has left its cell.
  void (*crossed)(void* context, int tile, bool stray, std::size_t index);
  /// Deforms `count` points from `first` on by gradients of displacement, row by row, each `stride` numbers.
  void (*deform)(void* context, std::size_t first, int count, const double* gradient, std::size_t stride);
};

/// The phases for one space, for one strip each.
struct Phases {
  int quantities; ///< of a square in Scratch::cells, at most
  int block;      ///< numbers in Scratch::block
  int tile;       ///< squares of a tile, about
  int n_means;    ///< arrays of Step::mean
  Edges edges;
  void (*scatter)(const Step&, int strip, const Scratch&);
  void (*accelerate)(const Step&, int strip);
  void (*displace)(const Step&, int strip);
  void (*move)(const Step&, int strip, const Scratch&);
};

/// The phases compiled for one instruction set.
struct Variant {
  const char* name;
  const Phases *triangles, *quadrilaterals, *plane_b_splines, *tetrahedra, *hexahedra, *solid_b_splines;
};

} // namespace settle::mpm::kernel
