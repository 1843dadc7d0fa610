/// \file
/// A case that gives every key a value that is not its default.
#pragma once

inline constexpr const char* full_case = R"(
format = 1
title = "Every key"
source = "a \"test\""
gravity = 9.5

[geometry]
shape = "column"
height = 6
width = 0.25
depth = 0.75
dimension = 3

[material.clay]
law = "neo-hookean"
youngs_modulus = 3e5
poissons_ratio = -0.1
density = 1800
porosity = 0.4

[material.sand]
law = "hencky"
youngs_modulus = 1e7
poissons_ratio = 0.3
density = 2000

[construction]
layers = 3
convention = "level-up"
material = "clay"

[mpm]
element = "hexahedron"
element_size = 0.5
points_per_element = 8
basis = "b-spline"
integration = "points"
refill = "element"
average_stress = true
scheme = "explicit"

[mpm.quasi_static]
increments = 7
residual = 1e-7
linear_solver = "direct"

[mpm.explicit]
relaxation = "local"
damping = 0.5
courant = 0.8
ramp_time = 11
hold = 12.5
force_error = 0.002
energy_error = 0.003
max_hold_time = 13
failure_displacement = 0.03
runout_damping = 0.1

[fem]
element = "Q2"
element_size = 0.75
kinematics = "finite"
increments = 9

[probes.axis]
x = 0.1
y = 0.2
points_per_layer = 5

[reference.other]
file = "other.csv"
title = "Another code"

[[check]]
quantity = "lateral-stress"
between = ["other", "fem"]
norm = "linf"
over = "probes"
stage = "all"
layers = [1, 3]
limit = 0.04
at_least = 0.01
scale = 1e3
why = "because"

[[check]]
quantity = "mass"
between = ["mpm", "exact"]
scale = "reference"
limit = 1

[converge]
element_size = [0.5, 0.25, 0.125]
set = { "mpm.quasi_static.increments" = [5, 10, 20], "construction.convention" = ["drop", "float", "refill"] }
size = "increment"

[[converge.expect]]
solver = "mpm"
quantity = "vertical-stress"
norm = "linf"
over = "probes"
against = "exact"
verdict = "converging"
order = 2
band = [0.1, 0.3]
finest_at_most = 0.01
above_fit_at_most = 2
why = "theory"

[[converge.expect]]
solver = "fem"
quantity = "settlement"
against = "self"
verdict = "oscillating"
)";
