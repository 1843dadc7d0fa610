/// \file
/// The case: everything a solver is told. Plain data, SI units, no physics.
///
/// The default member values here are the defaults of the case file; the ranges, units and descriptions of the keys
/// are in the one table of `src/case_keys.cpp`.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace settle::exchange {

/// `embankment`: polygons and supports made of a few lengths. `mesh`: those of a Gmsh file. `point`: no body, single
/// material points (`[[path]]`).
enum class Shape { column, polygons, embankment, mesh, point };
enum class Law { rate, hencky, neo_hookean, tresca, mohr_coulomb, drucker_prager, cam_clay, stress_dependent };
/// What a stage does.
enum class Action { ground, place, remove, hold, load };
enum class Convention { refill, level_up, floating, drop };
enum class MpmElement { triangle, quadrilateral, tetrahedron, hexahedron };
enum class Basis { linear, gimp, b_spline, b_spline_gimp };
enum class Integration { mixed, points };
enum class RefillRule { sub_element, element };
enum class Scheme { quasi_static, explicit_dynamic };
/// How the linear systems of the quasi-static scheme are solved.
enum class MpmLinearSolver { direct, iterative };
/// How the explicit scheme comes to rest.
enum class Relaxation { local, viscous };
enum class FemElement { Q1, Q2 };
enum class Kinematics { small, finite };
/// Of volume change in a cell: as it is, or its projection that does not lock.
enum class FemIntegration { full, b_bar };

/// How the finite element method solves the linear equations of an increment. automatic: `direct` in the plane, in
/// space `multigrid` but for a few cells.
enum class FemLinearSolver { automatic, direct, multigrid };
enum class Quantity {
  settlement,
  displacement, ///< all components
  vertical_stress,
  lateral_stress,
  shear_stress,
  stress, ///< xx yy zz xy, in 3-D all six
  density,
  base_reaction,
  mass,
  support_reaction, ///< size of the force that one support exerts
  failure_height,   ///< of the fill, where no equilibrium was found any more
  thrust,           ///< the horizontal force of each support
  plastic_strain    ///< accumulated, equivalent deviatoric
};
/// Directions in which a support prevents or prescribes motion.
enum class Held { x, y, both };
/// What a support does in the directions it holds: nothing, or the case's known motion.
enum class SupportMotion { none, exact };
enum class Norm { l2, linf };
enum class Over { automatic, points, probes, fields };
/// Where in a body is compared; near is nearer than two elements.
enum class Region {
  whole,
  interior, ///< all but `surface`
  surface,  ///< near the free surface of what is built
  base      ///< near the supports on which the body stands
};
enum class CheckStages { last, all };
/// How an error behaves under refinement; docs/convergence.md defines each. `undetermined`: nothing can be said.
enum class Convergence { converging, floor_limited, oscillating, diverging, undetermined };
/// What errors are held against under refinement: the size h of a level.
enum class RefinedSize { element_size, layer_thickness, increment };
/// What a refinement study measures: errors against the exact solution, or changes from level to level.
enum class ErrorAgainst { exact, self };

/// The names of an enumeration's values as they stand in case files, in the order of the values.
template <class Enum>
struct EnumNames;

template <>
struct EnumNames<Shape> {
  static constexpr std::array<std::string_view, 5> names{"column", "polygons", "embankment", "mesh", "point"};
};
template <>
struct EnumNames<Law> {
  static constexpr std::array<std::string_view, 8> names{
      "rate", "hencky", "neo-hookean", "tresca", "mohr-coulomb", "drucker-prager", "cam-clay", "stress-dependent"};
};
template <>
struct EnumNames<Action> {
  static constexpr std::array<std::string_view, 5> names{"ground", "place", "remove", "hold", "load"};
};
template <>
struct EnumNames<Convention> {
  static constexpr std::array<std::string_view, 4> names{"refill", "level-up", "float", "drop"};
};
template <>
struct EnumNames<MpmElement> {
  static constexpr std::array<std::string_view, 4> names{"triangle", "quadrilateral", "tetrahedron", "hexahedron"};
};
template <>
struct EnumNames<Basis> {
  static constexpr std::array<std::string_view, 4> names{"linear", "gimp", "b-spline", "b-spline-gimp"};
};
template <>
struct EnumNames<Integration> {
  static constexpr std::array<std::string_view, 2> names{"mixed", "points"};
};
template <>
struct EnumNames<RefillRule> {
  static constexpr std::array<std::string_view, 2> names{"sub-element", "element"};
};
template <>
struct EnumNames<Scheme> {
  static constexpr std::array<std::string_view, 2> names{"quasi-static", "explicit"};
};
template <>
struct EnumNames<MpmLinearSolver> {
  static constexpr std::array<std::string_view, 2> names{"direct", "iterative"};
};
template <>
struct EnumNames<Relaxation> {
  static constexpr std::array<std::string_view, 2> names{"local", "viscous"};
};
template <>
struct EnumNames<FemElement> {
  static constexpr std::array<std::string_view, 2> names{"Q1", "Q2"};
};
template <>
struct EnumNames<Kinematics> {
  static constexpr std::array<std::string_view, 2> names{"small", "finite"};
};
template <>
struct EnumNames<FemIntegration> {
  static constexpr std::array<std::string_view, 2> names{"full", "b-bar"};
};
template <>
struct EnumNames<FemLinearSolver> {
  static constexpr std::array<std::string_view, 3> names{"automatic", "direct", "multigrid"};
};
template <>
struct EnumNames<Quantity> {
  static constexpr std::array<std::string_view, 13> names{
      "settlement",    "displacement", "vertical-stress",  "lateral-stress", "shear-stress", "stress",        "density",
      "base-reaction", "mass",         "support-reaction", "failure-height", "thrust",       "plastic-strain"};
};
template <>
struct EnumNames<Held> {
  static constexpr std::array<std::string_view, 3> names{"x", "y", "both"};
};
template <>
struct EnumNames<SupportMotion> {
  static constexpr std::array<std::string_view, 2> names{"none", "exact"};
};
template <>
struct EnumNames<Norm> {
  static constexpr std::array<std::string_view, 2> names{"l2", "linf"};
};
template <>
struct EnumNames<Over> {
  static constexpr std::array<std::string_view, 4> names{"automatic", "points", "probes", "fields"};
};
template <>
struct EnumNames<Region> {
  static constexpr std::array<std::string_view, 4> names{"whole", "interior", "surface", "base"};
};
template <>
struct EnumNames<CheckStages> {
  static constexpr std::array<std::string_view, 2> names{"last", "all"};
};
template <>
struct EnumNames<Convergence> {
  static constexpr std::array<std::string_view, 5> names{"converging", "floor-limited", "oscillating", "diverging",
                                                         "undetermined"};
};
template <>
struct EnumNames<RefinedSize> {
  static constexpr std::array<std::string_view, 3> names{"element-size", "layer-thickness", "increment"};
};
template <>
struct EnumNames<ErrorAgainst> {
  static constexpr std::array<std::string_view, 2> names{"exact", "self"};
};

/// The name of a value as case files spell it.
template <class Enum>
constexpr std::string_view name_of(Enum value) {
  return EnumNames<Enum>::names[static_cast<std::size_t>(value)];
}

/// A part of a layer: a convex polygon, its corners anticlockwise.
struct Polygon {
  int layer = 1;                              ///< 1 ... N
  std::vector<std::vector<double>> corners{}; ///< (3 or more, 2) [m]
  std::string material{};                     ///< a name among the case's materials; empty: that of the construction
};

/// A symmetric or lopsided section with a level crest. x = 0 in the middle of the crest, y = 0 at the base of the fill.
struct Embankment {
  double height = 0.0;               ///< of the fill [m]
  double crest = 0.0;                ///< width of the crest [m]
  std::vector<double> slopes{};      ///< (2) left and right, horizontal per vertical [-]
  double foundation_depth = 0.0;     ///< 0: the fill stands on a rigid base; else layer 1 is the foundation [m]
  double foundation_left = 0.0;      ///< extent of the foundation beyond the toe [m]
  double foundation_right = 0.0;     ///< likewise
  std::string foundation_material{}; ///< empty: that of the construction
};

/// What an embankment closes as a dam: a valley along x with a level floor, y = 0 in the middle of it.
struct Valley {
  double bottom = 0.0;          ///< width of the floor along y; 0: none [m]
  std::vector<double> slopes{}; ///< (2) of the flanks towards -y and y, horizontal per vertical [-]
};

/// A cell of a mesh, by the numbers of its nodes: of a quadrilateral the first four, anticlockwise; of a hexahedron its
/// lower side, anticlockwise from above, and the upper side in the same order.
struct MeshCell {
  int layer = 1; ///< 1 ... N
  std::array<unsigned, 8> nodes{};
};

/// A named part of the boundary of a mesh that is held.
struct MeshBoundary {
  std::string name{};
  bool fixed = true;                          ///< in all directions; else across itself only, which is an axis
  std::vector<std::vector<unsigned>> sides{}; ///< each the numbers of 2 nodes, of a hexahedron 4; a plane section's run
                                              ///< with the body on the left
};

/// A mesh by Gmsh whose physical groups are layers and parts of the boundary.
struct Mesh {
  std::string file{};                             ///< relative to the case file's folder
  std::string text{};                             ///< what is in it; set by `read_case`
  std::vector<std::string> ground{};              ///< groups that are there at the start, from below: layers 1, 2, ...
  std::vector<std::string> layers{};              ///< groups in the order of construction: the layers after them
  std::map<std::string, std::string> materials{}; ///< group -> name of a material as TOML; left out: that of the
                                                  ///< construction
  std::vector<std::string> fixed{}, roller{};     ///< groups of the boundary that are held
  // Set by `read_case`, from `text`.
  int dimension = 2;                          ///< 2: a section of quadrilaterals; 3: hexahedra
  std::vector<std::array<double, 3>> nodes{}; ///< x, y, z [m]; z of a section is 0, and y its height
  std::vector<MeshCell> cells{};
  std::vector<MeshBoundary> boundaries{};
};

/// The domain that is built up.
struct Geometry {
  Shape shape = Shape::column;
  double height = 0.0;             ///< design height H [m]; set by `read_case` to the extent of polygons
  double width = 0.0;              ///< [m]; likewise
  std::optional<double> depth{};   ///< third dimension [m]; set by `read_case` to the width where a 3-D case leaves it
                                   ///< out, in a valley to the extent of the crest, of a mesh in space to its own
  int dimension = 2;               ///< 2 (plane strain) or 3
  std::vector<Polygon> polygons{}; ///< `[[geometry.polygon]]`; of an embankment and a mesh made by `read_case`
  std::optional<Embankment> embankment{}; ///< `[geometry.embankment]`, with the shape `embankment` only
  std::optional<Valley> valley{};         ///< `[geometry.valley]`, of an embankment in 3-D only
  std::optional<Mesh> mesh{};             ///< `[geometry.mesh]`, with the shape `mesh` only

  /// Does the body consist of polygons? Of a mesh in space they are its outline, seen along y.
  [[nodiscard]] bool drawn() const {
    return shape == Shape::polygons || shape == Shape::embankment || shape == Shape::mesh;
  }
  /// Is it a mesh in space?
  [[nodiscard]] bool solid_mesh() const { return mesh && mesh->dimension == 3; }
  /// Is it a body in space that is no extruded section?
  [[nodiscard]] bool varies_along_y() const { return valley || solid_mesh(); }
};

/// A straight part of the boundary of polygons that is held. A column has its oedometer without being told. Those of a
/// mesh are made by `read_case`: of a section one for each straight part of its boundaries that are held; in space one
/// for each boundary, in their order, from end to end of what it reaches along x and z.
struct Support {
  std::vector<double> from{}, to{}; ///< (2) its ends [m]
  Held held = Held::both;
  SupportMotion motion = SupportMotion::none;
  std::string boundary{}; ///< of a mesh, that it is part of
};

/// A motion known in closed form, by formulas of the position X, Y as placed and the time t (formulas.hpp).
struct Motion {
  std::vector<std::string> let{};          ///< "name = formula", each may use those before it
  std::vector<std::string> displacement{}; ///< (2) since placement [m]
  std::vector<std::string> stress{};       ///< (4) Cauchy, xx yy zz xy [Pa]; or none
  std::vector<std::string> velocity{};     ///< (2) [m/s]; or none: at rest
  std::vector<std::string> acceleration{}; ///< (2) [m/s2]; or none
  std::vector<std::string> body_force{};   ///< (2) per mass, besides gravity [m/s2]; or none
  std::optional<double> duration{};        ///< from t = 0 [s]; none: gravity is what loads
};

struct Material {
  Law law = Law::rate;
  double youngs_modulus = 0.0;      ///< E [Pa]
  double poissons_ratio = 0.0;      ///< nu [-]
  double density = 0.0;             ///< as placed [kg/m3]
  std::optional<double> porosity{}; ///< [-]; recorded, not used by one-phase solvers
  // Strength; which keys a law needs is in docs/formats.md.
  std::optional<double> cohesion{};         ///< c, or the undrained strength c_u of `tresca` [Pa]
  std::optional<double> friction_angle{};   ///< phi [degrees]
  std::optional<double> dilation_angle{};   ///< psi [degrees]; set by `read_case`: 0 where left out
  std::optional<double> tensile_strength{}; ///< no principal stress above it [Pa]; none: the apex is the limit
  // Modified Cam-clay.
  std::optional<double> critical_state_slope{};      ///< M, q = M p [-]
  std::optional<double> compression_index{};         ///< lambda, by the natural logarithm of pressure [-]
  std::optional<double> swelling_index{};            ///< kappa, likewise [-]
  std::optional<double> void_ratio{};                ///< e_0 as placed [-]
  std::optional<double> preconsolidation_pressure{}; ///< p_c as placed [Pa]
  std::optional<double> attraction{};                ///< p_t, added to the pressure [Pa]; set by `read_case`: 0
  // Stiffness that grows with stress.
  std::optional<double> stiffness_exponent{}; ///< m [-]
  std::optional<double> reference_pressure{}; ///< p_ref [Pa]
};

/// A step of the construction. `read_case` makes one for each layer where a case has none.
struct StageEntry {
  Action action = Action::place;
  int layer = 1; ///< of ground, place and remove; of hold and load the layer placed last, set by `read_case`
  std::optional<double> k0{}; ///< of ground: horizontal over vertical stress; none: as its law has it
  /// Of load [m]: ends of a straight part of the surface (2), of a mesh in space corners of a box (3).
  std::vector<double> from{}, to{};
  std::vector<double> traction{}; ///< of load, (2) or (3) likewise, reached at the end of the stage and kept [Pa]
};

/// A way of a single material point through strains or stresses, shape `point`. One stage.
struct PathLeg {
  int point = 1;                      ///< 1 ... number of points
  std::vector<std::string> control{}; ///< (6) "strain" or "stress"; set by `read_case`: all strain where left out
  std::vector<double> increment{};    ///< (6) xx yy zz xy yz xz of tensor strain [-] or stress [Pa]
  int increments = 1;                 ///< equal steps
};

/// State of single material points at the start.
struct InitialState {
  std::vector<double> stress{}; ///< (6) Cauchy [Pa]; set by `read_case` for points: zero where left out
};

struct Construction {
  int layers = 1;
  Convention convention = Convention::refill;
  std::string material{}; ///< a name among the case's materials
  bool may_fail = false;  ///< a stage that finds no equilibrium ends the construction, and is what is looked for
};

struct QuasiStatic {
  int increments = 20;    ///< of a layer's gravity, per stage
  double residual = 1e-9; ///< relative out-of-balance force accepted per increment [-]
  std::optional<MpmLinearSolver>
      linear_solver{}; ///< set by `read_case`: direct in 2-D, iterative in 3-D where left out
};

struct ExplicitDynamic {
  Relaxation relaxation = Relaxation::local;
  double damping = 0.75;             ///< local damping factor alpha, or share of the critical viscous damping [-]
  double courant = 0.9;              ///< fraction of the stable step [-]
  std::optional<double> ramp_time{}; ///< of a layer's gravity, per stage [s]; set by `read_case`: 10 where left out
                                     ///< with local damping; nothing: at once
  std::optional<double> hold{};      ///< hold after the ramp [s]; nothing: until equilibrium
  double force_error = 0.001;        ///< sum|F_unbalanced| / sum|F_external| [-]
  double energy_error = 0.001;       ///< kinetic energy / work of external forces [-]
  double max_hold_time = 600.0;      ///< [s]
  // Where a case may fail.
  double failure_displacement = 0.02; ///< of a point since the last equilibrium, over the height of the fill [-]
  double runout_damping = 0.05;       ///< local damping factor after failure [-]
};

/// What the material point method is told.
struct Mpm {
  MpmElement element = MpmElement::triangle;
  double element_size = 0.125;             ///< [m]
  std::optional<int> points_per_element{}; ///< set by `read_case`: 3, 4, 4, 8 by element where left out
  Basis basis = Basis::linear;
  Integration integration = Integration::mixed;
  RefillRule refill = RefillRule::sub_element;
  bool average_stress = false;
  bool jaumann = false;
  int threads = 1; ///< results do not depend on it
  Scheme scheme = Scheme::quasi_static;
  QuasiStatic quasi_static{};
  ExplicitDynamic explicit_dynamic{}; ///< the table `[mpm.explicit]`
};

/// What the finite element method is told.
struct Fem {
  FemElement element = FemElement::Q1;
  double element_size = 0.125; ///< [m]; set by `read_case` for a mesh: the root of its cells' mean area
  Kinematics kinematics = Kinematics::small;
  std::optional<FemIntegration> integration{}; ///< none: b-bar where a material of the case yields, else full
  std::optional<int> increments{};             ///< per stage; set by `read_case`: 1 (small), 4 (finite) where left out
  FemLinearSolver linear_solver = FemLinearSolver::automatic;
  int threads = 1; ///< the result is the same, to the bit, for the same number
};

/// A line of material points that every solver samples: vertical in a column, any straight line across polygons.
struct Probes {
  std::optional<double> x{};        ///< [m]; set by `read_case` to the middle of the column where left out
  std::optional<double> y{};        ///< [m]; 3-D only, likewise
  int points_per_layer = 9;         ///< of a column, both ends of the layer included
  std::vector<double> from{}, to{}; ///< (2), in a valley or a mesh in space (3), ends of the line across polygons [m];
                                    ///< empty in a column
  std::optional<int> points{};      ///< of the line across polygons, both ends included; none: 9
};

/// A table of another code's results at material points, read from a CSV file (see docs/formats.md).
struct Reference {
  std::string file{}; ///< path, relative to the case file's folder
  std::string title{};
};

/// One comparison and the limit it is held to.
struct Check {
  Quantity quantity = Quantity::settlement;
  std::vector<std::string> between{}; ///< two of: a solver's name, "exact", a reference's name
  Norm norm = Norm::l2;
  Over over = Over::automatic; ///< automatic: points for a leg with exact, probes between solvers
  Region region = Region::whole;
  CheckStages stages = CheckStages::last;
  std::vector<int> layers{};     ///< first and last layer compared; empty: all
  double limit = 0.0;            ///< relative to `scale`
  double at_least = 0.0;         ///< lower end of an expected band, relative to `scale`
  std::optional<double> scale{}; ///< SI units of the quantity; nothing: the same norm of the reference
  std::optional<int> support{};  ///< of a support reaction: its number in the case, from 1
  std::string exact{};           ///< formula of the exact value of a quantity that has one value; empty: none
  std::string why{};
};

/// What a case expects of a solver under refinement.
struct ExpectedConvergence {
  std::string solver{}; ///< "mpm" or "fem"
  Quantity quantity = Quantity::settlement;
  Norm norm = Norm::l2;
  Over over = Over::points;
  ErrorAgainst against = ErrorAgainst::exact;
  Convergence verdict = Convergence::converging;
  std::optional<double> order{};             ///< of a converging error [-]
  std::vector<double> band{0.2, 0.5};        ///< accepted below and above the order [-]
  std::optional<double> finest_at_most{};    ///< relative error of the finest level [-]
  std::optional<double> above_fit_at_most{}; ///< largest error of a level over the fitted line [-]
  std::optional<int> support{};              ///< as of a check
  std::string exact{};                       ///< as of a check
  std::string why{};
};

/// The levels of a refinement study, coarse to fine, and what is expected of them.
struct Refinement {
  std::vector<double> element_size{};                    ///< of both solvers, for each level [m]; empty: not varied
  std::map<std::string, std::vector<std::string>> set{}; ///< dotted key -> TOML value for each level
  RefinedSize size = RefinedSize::element_size;
  std::vector<ExpectedConvergence> expectations{}; ///< `[[converge.expect]]`

  /// How many levels there are; lists of different lengths are refused by `read_case`.
  [[nodiscard]] std::size_t levels() const;
};

/// A whole case file after defaults and overrides.
struct Case {
  int format = 1;
  std::string title{};
  std::string source{};
  double gravity = 0.0; ///< [m/s2]
  Geometry geometry{};
  std::map<std::string, Material> materials{}; ///< `[material.NAME]`
  Construction construction{};
  Mpm mpm{};
  Fem fem{};
  std::map<std::string, Probes> probes{};        ///< `[probes.NAME]`
  std::map<std::string, Reference> references{}; ///< `[reference.NAME]`
  std::vector<Check> checks{};                   ///< `[[check]]`
  std::optional<Refinement> converge{};          ///< `[converge]`
  std::vector<Support> supports{};               ///< `[[support]]`, of polygons
  std::optional<Motion> motion{};                ///< `[motion]`, of polygons
  std::vector<StageEntry> stages{};              ///< `[[stage]]`; set by `read_case`: one for each layer where left out
  std::vector<PathLeg> paths{};                  ///< `[[path]]`, of points
  InitialState initial{};                        ///< `[initial]`, of points

  std::string file{};                           ///< as given by the user
  std::map<std::string, std::string> origins{}; ///< dotted key -> `file:line:column` or `--set ...`; only keys given

  /// The material of the fill. Throws std::out_of_range only if the case did not come from `read_case`.
  [[nodiscard]] const Material& fill() const { return materials.at(construction.material); }
  /// The material of a layer. Throws as `fill`.
  [[nodiscard]] const Material& material_of(int layer) const;
  /// `stages`, or one for each layer in a case that did not come from `read_case`.
  [[nodiscard]] std::vector<StageEntry> all_stages() const;
  /// How many stages there are: groups of a result, legs of the path of a point.
  [[nodiscard]] int n_stages() const;
  /// The layer of stage 1, 2, ...: that of its entry; 1 for single material points.
  [[nodiscard]] int layer_of_stage(int stage) const;
  /// The layers that are there after a stage.
  [[nodiscard]] std::set<int> layers_present(int stage) const;
  /// Where a key was given, for messages: `file:line:column`, `--set ...`, or the file's name when it was left out.
  [[nodiscard]] std::string where(const std::string& key) const;
  /// Design thickness of a layer of a column [m].
  [[nodiscard]] double layer_thickness() const { return geometry.height / construction.layers; }
};

} // namespace settle::exchange
