#include "case_keys.hpp"

#include "geometry_keys.hpp"
#include "material_keys.hpp"
#include "stage_keys.hpp"

namespace settle::exchange {
namespace {

constexpr std::size_t plane = 2;

KeyTable<Support> support_keys() {
  KeyTable<Support> keys("A straight part of the boundary of polygons that is held; a column has its oedometer.");
  const Count point{.least = plane, .most = plane};
  keys.reals("from", &Support::from,
             {.unit = "m",
              .count = point,
              .required = true,
              .doc = "`[x, y]` of one end; the body lies to the left of the way to the other"});
  keys.reals("to", &Support::to, {.unit = "m", .count = point, .required = true, .doc = "`[x, y]` of the other end"});
  keys.choice("held", &Support::held, {.doc = "directions in which it holds"});
  keys.choice("motion", &Support::motion, {.doc = "nothing moves, or everything held follows the case's `[motion]`"});
  return keys;
}

KeyTable<Motion> motion_keys() {
  KeyTable<Motion> keys("A motion known in closed form, by formulas; what loads it, and what is exact.");
  const Count vector{.least = plane, .most = plane};
  const Count tensor{.least = 4, .most = 4};
  keys.texts("let", &Motion::let,
             {.doc = "`\"name = formula\"`, abbreviations for all formulas; each may use those before it"});
  keys.texts("displacement", &Motion::displacement,
             {.unit = "m", .count = vector, .required = true, .doc = "exact, since placement: x, y"});
  keys.texts("stress", &Motion::stress,
             {.unit = "Pa", .count = tensor, .left_out = "not known", .doc = "exact Cauchy stress: xx, yy, zz, xy"});
  keys.texts("velocity", &Motion::velocity,
             {.unit = "m/s",
              .count = vector,
              .left_out = "at rest",
              .doc = "exact: x, y; what an explicit scheme starts with"});
  keys.texts("acceleration", &Motion::acceleration,
             {.unit = "m/s2",
              .count = vector,
              .left_out = "none",
              .doc = "exact: x, y; a solver without inertia takes it off the body force"});
  keys.texts("body_force", &Motion::body_force,
             {.unit = "m/s2", .count = vector, .left_out = "none", .doc = "per mass, besides gravity: x, y"});
  keys.real("duration", &Motion::duration,
            {.unit = "s",
             .range = above(0),
             .left_out = "gravity is raised, layer by layer",
             .doc = "from t = 0, in one stage without a ramp of gravity"});
  return keys;
}

KeyTable<Construction> construction_keys() {
  KeyTable<Construction> keys("How the domain is built up. Required.");
  keys.integer("layers", &Construction::layers,
               {.range = at_least(1),
                .required = true,
                .doc = "number of layers; those of a column are of equal design thickness"});
  keys.choice("convention", &Construction::convention,
              {.required = true, .doc = "where a new layer is placed and what makes up for settlement"});
  keys.text("material", &Construction::material, {.required = true, .doc = "the NAME of a `[material.NAME]`"});
  keys.boolean("may_fail", &Construction::may_fail,
               {.doc = "a stage that finds no equilibrium ends the construction and is its result, not an error"});
  return keys;
}

KeyTable<QuasiStatic> quasi_static_keys() {
  KeyTable<QuasiStatic> keys("The implicit scheme of the material point method.");
  keys.integer("increments", &QuasiStatic::increments,
               {.range = at_least(1), .doc = "steps in which a layer's gravity is applied, per stage"});
  keys.real("residual", &QuasiStatic::residual,
            {.range = between(0, 1), .doc = "relative out-of-balance force at which an increment is accepted"});
  keys.choice("linear_solver", &QuasiStatic::linear_solver,
              {.left_out = "\"direct\" in 2-D, \"iterative\" in 3-D",
               .doc = "a complete factorisation, or iterations with an incomplete one"});
  return keys;
}

KeyTable<ExplicitDynamic> explicit_keys() {
  using Explicit = ExplicitDynamic;
  KeyTable<Explicit> keys("The explicit scheme of the material point method: a ramp of gravity, then a hold.");
  keys.choice(
      "relaxation", &Explicit::relaxation,
      {.doc = "damping by the unbalanced force of each node, or viscous by the lowest frequency (docs/mpm.md)"});
  keys.real("damping", &Explicit::damping,
            {.range = from_to_below(0, 1), .doc = "local damping factor, or share of the critical viscous damping"});
  keys.real("courant", &Explicit::courant, {.range = above_to(0, 1), .doc = "fraction of the stable time step"});
  keys.real("ramp_time", &Explicit::ramp_time,
            {.unit = "s",
             .range = above(0),
             .left_out = "10 (local), gravity at once (viscous)",
             .doc = "time over which a layer's gravity grows, per stage"});
  keys.real_or_word("hold", &Explicit::hold, "equilibrium",
                    {.unit = "s", .range = at_least(0), .doc = "how long full gravity is held; 0: an unheld ramp"});
  keys.real("force_error", &Explicit::force_error,
            {.range = between(0, 1), .doc = "equilibrium: largest sum of unbalanced over sum of external forces"});
  keys.real("energy_error", &Explicit::energy_error,
            {.range = between(0, 1), .doc = "equilibrium: largest kinetic energy over work of external forces"});
  keys.real("max_hold_time", &Explicit::max_hold_time,
            {.unit = "s", .range = above(0), .doc = "no equilibrium after this time of holding is an error"});
  keys.real(
      "failure_displacement", &Explicit::failure_displacement,
      {.range = between(0, 1),
       .doc = "with `may_fail`: a point that moves this share of the fill's height without equilibrium is failure"});
  keys.real("runout_damping", &Explicit::runout_damping,
            {.range = from_to_below(0, 1), .doc = "with `may_fail`: local damping factor from failure to rest"});
  return keys;
}

KeyTable<Mpm> mpm_keys() {
  KeyTable<Mpm> keys("What the material point method is told.");
  keys.choice("element", &Mpm::element,
              {.doc = "cells of the background grid: the first two in 2-D, the others in 3-D"});
  keys.real(
      "element_size", &Mpm::element_size,
      {.unit = "m", .range = above(0), .doc = "edge of a grid cell; the layer thickness must be a multiple of it"});
  keys.integer("points_per_element", &Mpm::points_per_element,
               {.range = at_least(1),
                .left_out = "3 (triangle), 4 (quadrilateral, tetrahedron), 8 (hexahedron)",
                .doc = "material points placed in each cell"});
  keys.choice("basis", &Mpm::basis, {.doc = "shape functions of the grid"});
  keys.choice("integration", &Mpm::integration,
              {.doc = "internal force from the cell's averaged stress over its full area, or from the points"});
  keys.choice("refill", &Mpm::refill, {.doc = "material is added in rows of points, or in whole empty elements"});
  keys.boolean("jaumann", &Mpm::jaumann,
               {.doc = "law rate: rotate the stress with the material (Jaumann rate); matters where layers rotate"});
  keys.boolean("average_stress", &Mpm::average_stress,
               {.doc = "replace point stresses by the cell's average after each move"});
  keys.integer("threads", &Mpm::threads,
               {.range = at_least(1), .doc = "threads of one run; results are the same, bit for bit, for any number"});
  keys.choice("scheme", &Mpm::scheme, {.doc = "implicit increments of gravity, or damped time steps"});
  keys.table("quasi_static", &Mpm::quasi_static, quasi_static_keys());
  keys.table("explicit", &Mpm::explicit_dynamic, explicit_keys());
  return keys;
}

KeyTable<Fem> fem_keys() {
  KeyTable<Fem> keys("What the finite element method is told.");
  keys.choice("element", &Fem::element, {.doc = "degree of the shape functions"});
  keys.real("element_size", &Fem::element_size,
            {.unit = "m",
             .range = above(0),
             .doc = "edge of a cell; the layer thickness must be a multiple of it; of a mesh its own"});
  keys.choice("kinematics", &Fem::kinematics, {.doc = "small strains on the design geometry, or finite strains"});
  keys.choice("integration", &Fem::integration,
              {.left_out = "b-bar where a material yields, else full",
               .doc = "of a cell's change of volume: in full, or by the projection (B-bar) that does not lock"});
  keys.integer("increments", &Fem::increments,
               {.range = at_least(1),
                .left_out = "1 (small), 4 (finite)",
                .doc = "steps in which a layer's gravity is applied, per stage"});
  keys.choice("linear_solver", &Fem::linear_solver,
              {.doc =
                   "sparse factors, or a Krylov method with algebraic multigrid; `automatic`: factors in 2-D and for "
                   "3000 degrees of freedom or fewer, else multigrid"});
  keys.integer("threads", &Fem::threads, {.range = at_least(1), .doc = "threads of one run; a campaign runs several"});
  return keys;
}

KeyTable<Probes> probes_keys() {
  KeyTable<Probes> keys("A line of material points that every solver samples, vertical in a column; NAME is yours.");
  const Count point{.least = plane, .most = plane + 1};
  keys.real("x", &Probes::x, {.unit = "m", .left_out = "the middle", .doc = "position of the line"});
  keys.real("y", &Probes::y, {.unit = "m", .left_out = "the middle", .doc = "position of the line, in 3-D only"});
  keys.integer("points_per_layer", &Probes::points_per_layer,
               {.range = at_least(2), .doc = "points in each layer of a column, both of its ends included"});
  keys.reals("from", &Probes::from,
             {.unit = "m",
              .count = point,
              .left_out = "required for polygons",
              .doc = "`[x, y]` of one end; in a valley and a mesh of hexahedra `[x, y, z]`"});
  keys.reals("to", &Probes::to,
             {.unit = "m", .count = point, .left_out = "required for polygons", .doc = "likewise of the other end"});
  keys.integer("points", &Probes::points,
               {.range = at_least(2),
                .left_out = "9",
                .doc = "points across polygons, both ends included; one that lies on an "
                       "interface is taken in each of its layers"});
  return keys;
}

KeyTable<Reference> reference_keys() {
  KeyTable<Reference> keys("Another code's results at material points, as a table; NAME is yours.");
  keys.text("file", &Reference::file, {.required = true, .doc = "CSV file, relative to the folder of the case file"});
  keys.text("title", &Reference::title, {.doc = "what reports call it"});
  return keys;
}

KeyTable<Check> check_keys_table() {
  KeyTable<Check> keys("One comparison and the limit it is held to.");
  keys.choice("quantity", &Check::quantity, {.required = true, .doc = "what is compared"});
  keys.texts("between", &Check::between,
             {.count = {.least = 2, .most = 2},
              .required = true,
              .doc = "`\"mpm\"`, `\"fem\"`, `\"exact\"` or the NAME of a `[reference.NAME]` or of a solver "
                     "that joins; the second one is the reference"});
  keys.choice("norm", &Check::norm, {.doc = "root of the volume-weighted mean square, or the largest difference"});
  keys.choice_or_left_out("over", &Check::over, Over::automatic,
                          {.left_out = "points where `\"exact\"` takes part, else probes",
                           .doc = "native points of the solver, the case's probes, or, of two solvers of drawn bodies, "
                                  "the points of one and the other's field there"});
  keys.choice("region", &Check::region,
              {.doc = "of a drawn body: all of it, what is further than two elements from its free surface, what is "
                      "nearer, or what is nearer than that to the supports it stands on"});
  keys.choice("stage", &Check::stages, {.doc = "the last stage, or every one"});
  keys.integers("layers", &Check::layers,
                {.range = at_least(1),
                 .count = {.least = 2, .most = 2},
                 .left_out = "all layers",
                 .doc = "first and last layer compared"});
  keys.real("limit", &Check::limit,
            {.range = at_least(0), .required = true, .doc = "upper end of what passes, over `scale`"});
  keys.real("at_least", &Check::at_least,
            {.range = at_least(0), .doc = "lower end of what passes, over `scale`: an expected difference"});
  keys.real_or_word(
      "scale", &Check::scale, "reference",
      {.range = above(0), .doc = "the same norm of the reference, or a number in SI units of the quantity"});
  keys.integer(
      "support", &Check::support,
      {.range = at_least(1), .left_out = "required for a support reaction", .doc = "its number in the case, from 1"});
  keys.text("exact", &Check::exact,
            {.doc = "formula of the exact value, of a quantity that has one value; constants as in `[motion]`, and no "
                    "X, Y, t, layer, stage"});
  keys.text("why", &Check::why, {.doc = "the reason for the limit, shown in reports"});
  return keys;
}

KeyTable<ExpectedConvergence> expectation_keys() {
  using Expected = ExpectedConvergence;
  KeyTable<Expected> keys("What is expected of a solver when its errors are followed over the levels of `[converge]`.");
  keys.text("solver", &Expected::solver, {.required = true, .doc = "`\"mpm\"` or `\"fem\"`"});
  keys.choice("quantity", &Expected::quantity, {.required = true, .doc = "what is compared, after the last stage"});
  keys.choice("norm", &Expected::norm, {.doc = "as in `[[check]]`"});
  keys.choice_or_left_out("over", &Expected::over, Over::automatic,
                          {.doc = "native points of the solver, or the case's probes"});
  keys.choice("against", &Expected::against,
              {.doc = "errors against the exact solution, or changes of the norm itself from level to level"});
  keys.choice_or_left_out("verdict", &Expected::verdict, Convergence::undetermined,
                          {.doc = "see docs/convergence.md; a case may expect that there is no convergence"});
  keys.real("order", &Expected::order,
            {.range = above(0), .left_out = "none", .doc = "expected order; required where `converging` is expected"});
  keys.reals("band", &Expected::band,
             {.range = at_least(0),
              .count = {.least = 2, .most = 2},
              .doc = "how far below and above `order` the fitted order may lie"});
  keys.real(
      "finest_at_most", &Expected::finest_at_most,
      {.range = above(0),
       .left_out = "not judged",
       .doc = "largest relative error accepted on the finest level; against itself: largest grid convergence index"});
  keys.real("above_fit_at_most", &Expected::above_fit_at_most,
            {.range = at_least(1),
             .left_out = "not judged",
             .doc = "how many times the fitted line an error may be, on any level"});
  keys.integer("support", &Expected::support,
               {.range = at_least(1), .left_out = "as in `[[check]]`", .doc = "as in `[[check]]`"});
  keys.text("exact", &Expected::exact, {.doc = "as in `[[check]]`"});
  keys.text("why", &Expected::why, {.doc = "the reason for what is expected, shown in reports"});
  return keys;
}

KeyTable<Refinement> refinement_keys() {
  KeyTable<Refinement> keys(
      "The levels of a refinement study, coarse to fine. All lists have one entry for each level, at least three.");
  keys.reals("element_size", &Refinement::element_size,
             {.unit = "m",
              .range = above(0),
              .count = {.least = 3},
              .left_out = "not varied",
              .doc = "`mpm.element_size` and `fem.element_size` of each level"});
  keys.toml_lists("set", &Refinement::set, {.doc = "further keys of the case with their values on each level"});
  keys.choice("size", &Refinement::size,
              {.doc = "what orders refer to: the solver's element size, the thickness of a layer, or one over the "
                      "solver's increments"});
  keys.table_array("expect", &Refinement::expectations, expectation_keys());
  return keys;
}

} // namespace

KeyTable<Case> case_keys() {
  KeyTable<Case> keys("Keys at the top of the file.");
  keys.integer("format", &Case::format,
               {.range = exactly(1),
                .required = true,
                .hint = "this program reads case files of format 1",
                .doc = "version of the case format"});
  keys.text("title", &Case::title, {.doc = "what reports call the case"});
  keys.text("source", &Case::source, {.doc = "where the case comes from"});
  keys.real("gravity", &Case::gravity,
            {.unit = "m/s2",
             .range = at_least(0),
             .required = true,
             .doc = "acceleration of gravity, a positive number; 0 without a column only"});
  keys.table("geometry", &Case::geometry, geometry_keys(), {.required = true});
  keys.named_tables("material", &Case::materials, material_keys(), {.required = true});
  keys.table("construction", &Case::construction, construction_keys(), {.required = true});
  keys.table("mpm", &Case::mpm, mpm_keys());
  keys.table("fem", &Case::fem, fem_keys());
  keys.named_tables("probes", &Case::probes, probes_keys());
  keys.named_tables("reference", &Case::references, reference_keys());
  keys.table_array("check", &Case::checks, check_keys_table());
  keys.table("converge", &Case::converge, refinement_keys());
  keys.table_array("support", &Case::supports, support_keys());
  keys.table("motion", &Case::motion, motion_keys());
  keys.table_array("stage", &Case::stages, stage_keys());
  keys.table_array("path", &Case::paths, path_keys());
  keys.table("initial", &Case::initial, initial_keys());
  return keys;
}

} // namespace settle::exchange
