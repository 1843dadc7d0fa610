/// \file
/// What the kernels of the explicit step work on: plain pointers and numbers. The kernels are compiled once for every
/// instruction set, so what they share with other code holds no function that a linker could take from the wrong one.
#pragma once

#include <cstddef>
#include <cstdint>

namespace settle::mpm::kernel {

/// Arrays of points. In 2-D.
struct PointArrays {
  const double* mass;
  double* volume;
  double* position[2];
  double* velocity[2];
  double* stress[4]; ///< xx yy zz xy
  const std::int32_t* layer;
  const double* force[2]; ///< per mass, besides gravity [m/s2]; null: none
};

/// Points in a strip that have left the range of their cell since the points were sorted; in any order.
struct Strays {
  PointArrays points;
  const std::int32_t* cell;
  std::size_t count;
};

/// Arrays over the nodes, with zeros before the first and after the last, as far as edges reach.
enum NodeArray {
  node_mass,         ///< lumped
  node_momentum,     ///< x, y; once moved: displacement in the step
  node_force = 3,    ///< x, y: internal; once accelerated: acceleration
  node_external = 5, ///< y, x; x only where points have a force besides gravity
  node_matrix = 7    ///< consistent mass: diagonal, then the couplings with node + edge
};
inline constexpr int max_edges = 12;
inline constexpr int max_node_arrays = node_matrix + 1 + max_edges;

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
  with_force ///< the same, and by their force besides
};
struct StripWeight {
  Weight kind;
  double gravity; ///< where uniform [m/s2]
};

/// Memory of one thread.
struct Scratch {
  double* block; ///< quantities of a block of points
  double* cells; ///< quantities of the squares of a strip
  double* nodes; ///< arrays of the nodes of a strip
};

/// A step. Squares are numbered like the node at their lower left, so that each row ends with squares that do not exist
/// and hold nothing: whatever goes from cells to nodes or back is then a loop over one index.
struct Step {
  int columns, rows;     ///< of squares
  int node_columns;      ///< squares of a row, those that do not exist included
  int overlap;           ///< rows of nodes that a square touches besides its own
  int strip_rows;        ///< rows of squares in a strip
  int n_strips;          ///< of squares; nodes have one more, which owns the uppermost rows
  std::size_t margin;    ///< zeros before the first square in Scratch::cells
  std::size_t stride;    ///< from one quantity to the next in Scratch::cells
  std::size_t n_nodes;   ///< from one array to the next in Scratch::nodes: those of a strip and of its overlap
  double origin[2];      ///< [m]
  double inverse_size;   ///< [1/m]
  double cell_volume;    ///< [m3/m]
  bool full_cells;       ///< mixed integration
  double lambda, mu;     ///< [Pa]
  double density;        ///< as placed [kg/m3]
  bool rate;             ///< the law `rate` without rotation; other laws come in through `deform`
  bool hyperelastic;     ///< stiffness follows density and stress
  double gravity;        ///< [m/s2]
  double ramped_gravity; ///< of the layer under construction
  int ramped_layer;
  double damping, kick, dt; ///< dt: of positions and strains; kick: of velocities [s]
  double kept;              ///< of velocities after they have changed [-]

  PointArrays points;
  const std::uint32_t* begin; ///< by cell
  const Strays* strays;       ///< by strip

  double* node[max_node_arrays]; ///< null: none
  double* overlap_nodes;         ///< by strip, array, node: what it adds to the nodes of the next one
  int n_node_arrays;
  int edge[max_edges];         ///< from a node to the one it couples with
  const std::uint8_t* held;    ///< by node: 1: x, 2: y
  const std::uint8_t* touched; ///< by strip: does it hold points?
  double* mean;                ///< by quantity, square: what the mean gradient of a cell is off by; null: none
  std::size_t mean_stride;
  double* column_volume;     ///< by strip, column [m3/m]
  const StripWeight* weight; ///< by strip
  StripSums* sums;           ///< by strip of nodes

  void* context;
  /// A point of the strip, or a stray, has left its cell.
  void (*crossed)(void* context, int strip, bool stray, std::size_t index);
  /// Deforms `count` points from `first` on by gradients of displacement, xx xy yx yy, each `stride` numbers.
  void (*deform)(void* context, std::size_t first, int count, const double* gradient, std::size_t stride);
};

/// The phases for one space, for one strip each.
struct Phases {
  int quantities; ///< of a square in Scratch::cells, at most
  int block;      ///< numbers in Scratch::block
  int n_edges;
  int n_means; ///< arrays of Step::mean
  void (*scatter)(const Step&, int strip, const Scratch&);
  void (*accelerate)(const Step&, int strip);
  void (*displace)(const Step&, int strip);
  void (*move)(const Step&, int strip, const Scratch&);
};

/// The phases compiled for one instruction set.
struct Variant {
  const char* name;
  Phases triangles, quadrilaterals, b_splines;
};

} // namespace settle::mpm::kernel
