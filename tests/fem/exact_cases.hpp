/// \file
/// Cases of polygons whose motion is known in closed form, as case files.
#pragma once

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace settle::fem::testing {

/// A uniform deformation prescribed all around distorted polygons (Irons & Razzaque 1972).
constexpr const char* patch_case = R"toml(
format = 1
title = "Patch test: a uniform deformation prescribed all around distorted polygons"
gravity = 0.0

[geometry]
shape = "polygons"
dimension = 2
[[geometry.polygon]]
corners = [[0.0, 0.0], [1.2, 0.0], [0.9, 0.7], [0.0, 1.0]]
[[geometry.polygon]]
corners = [[1.2, 0.0], [2.0, 0.0], [2.0, 1.3], [0.9, 0.7]]
[[geometry.polygon]]
corners = [[0.0, 1.0], [0.9, 0.7], [0.8, 2.0], [0.0, 2.0]]
[[geometry.polygon]]
corners = [[0.9, 0.7], [2.0, 1.3], [0.8, 2.0]]
[[geometry.polygon]]
corners = [[2.0, 1.3], [2.0, 2.0], [0.8, 2.0]]

[material.soil]
law = "neo-hookean"
youngs_modulus = 1e6
poissons_ratio = 0.3
density = 1800.0

[construction]
layers = 1
convention = "drop"
material = "soil"

[fem]
element_size = 0.25
kinematics = "finite"
increments = 4

[probes.across]
from = [0.0, 0.1]
to = [2.0, 1.9]
points = 23

[[support]]
from = [0.0, 0.0]
to = [2.0, 0.0]
motion = "exact"
[[support]]
from = [2.0, 0.0]
to = [2.0, 2.0]
motion = "exact"
[[support]]
from = [2.0, 2.0]
to = [0.0, 2.0]
motion = "exact"
[[support]]
from = [0.0, 2.0]
to = [0.0, 0.0]
motion = "exact"

[motion]
let = ["a = 0.10 * t", "b = 0.20 * t", "c = -0.05 * t", "d = -0.15 * t", "J = (1 + a) * (1 + d) - b * c"]
displacement = ["a * X + b * Y", "c * X + d * Y"]
stress = [
  "(lambda * ln(J) + mu * ((1 + a)^2 + b^2 - 1)) / J",
  "(lambda * ln(J) + mu * (c^2 + (1 + d)^2 - 1)) / J",
  "lambda * ln(J) / J",
  "mu * ((1 + a) * c + b * (1 + d)) / J",
]
duration = 1.0
)toml";

/// Wallstedt & Guilkey (2008), axis-aligned displacement; duration: a quarter of the period 2/c.
constexpr const char* axis_aligned_case = R"toml(
format = 1
title = "R6: manufactured motion along the axes of a square"
gravity = 0.0

[geometry]
shape = "polygons"
dimension = 2
[[geometry.polygon]]
corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]

[material.soil]
law = "neo-hookean"
youngs_modulus = 1e7
poissons_ratio = 0.3
density = 1000.0

[construction]
layers = 1
convention = "drop"
material = "soil"

[fem]
element_size = 0.0625
kinematics = "finite"
increments = 2

[probes.across]
from = [0.0, 0.1]
to = [1.0, 0.8]
points = 17

[[support]]
from = [0.0, 0.0]
to = [1.0, 0.0]
held = "y"
[[support]]
from = [1.0, 0.0]
to = [1.0, 1.0]
held = "x"
[[support]]
from = [1.0, 1.0]
to = [0.0, 1.0]
held = "y"
[[support]]
from = [0.0, 1.0]
to = [0.0, 0.0]
held = "x"

[motion] # duration: a quarter of the period 2/c
let = [
  "A = 0.05",
  "c = sqrt(E / rho)",
  "p = A * sin(2 * pi * X) * sin(c * pi * t)",
  "q = A * sin(2 * pi * Y) * sin(c * pi * t + pi)",
  "F = 1 + 2 * pi * A * cos(2 * pi * X) * sin(c * pi * t)",
  "G = 1 + 2 * pi * A * cos(2 * pi * Y) * sin(c * pi * t + pi)",
  "J = F * G",
]
displacement = ["p", "q"]
velocity = [
  "A * c * pi * sin(2 * pi * X) * cos(c * pi * t)",
  "A * c * pi * sin(2 * pi * Y) * cos(c * pi * t + pi)",
]
acceleration = ["-p * (c * pi)^2", "-q * (c * pi)^2"]
body_force = [
  "pi^2 * p * (4 * mu / rho - c^2 - 4 * (lambda * (ln(J) - 1) - mu) / (rho * F^2))",
  "pi^2 * q * (4 * mu / rho - c^2 - 4 * (lambda * (ln(J) - 1) - mu) / (rho * G^2))",
]
stress = [
  "(lambda * ln(J) + mu * (F^2 - 1)) / J",
  "(lambda * ln(J) + mu * (G^2 - 1)) / J",
  "lambda * ln(J) / J",
  "0",
]
duration = 0.005
)toml";

/// The generalized vortex of Kamojjala, Brannon, Sadeghirad & Guilkey (2015) in a square at rest: a ring turned by
/// turn(t) h(R); duration: half the period, where the turn is largest.
constexpr const char* vortex_case = R"toml(
format = 1
title = "R7: generalized vortex in a square at rest, around a square hole"
gravity = 0.0

[geometry]
shape = "polygons"
dimension = 2
[[geometry.polygon]]
corners = [[-1.5, -1.5], [-0.5, -1.5], [-0.5, -0.5], [-1.5, -0.5]]
[[geometry.polygon]]
corners = [[-0.5, -1.5], [0.5, -1.5], [0.5, -0.5], [-0.5, -0.5]]
[[geometry.polygon]]
corners = [[0.5, -1.5], [1.5, -1.5], [1.5, -0.5], [0.5, -0.5]]
[[geometry.polygon]]
corners = [[-1.5, -0.5], [-0.5, -0.5], [-0.5, 0.5], [-1.5, 0.5]]
[[geometry.polygon]]
corners = [[0.5, -0.5], [1.5, -0.5], [1.5, 0.5], [0.5, 0.5]]
[[geometry.polygon]]
corners = [[-1.5, 0.5], [-0.5, 0.5], [-0.5, 1.5], [-1.5, 1.5]]
[[geometry.polygon]]
corners = [[-0.5, 0.5], [0.5, 0.5], [0.5, 1.5], [-0.5, 1.5]]
[[geometry.polygon]]
corners = [[0.5, 0.5], [1.5, 0.5], [1.5, 1.5], [0.5, 1.5]]

[material.soil]
law = "neo-hookean"
youngs_modulus = 1000.0
poissons_ratio = 0.3
density = 1000.0

[construction]
layers = 1
convention = "drop"
material = "soil"

[fem]
element_size = 0.1
kinematics = "finite"
increments = 4

[probes.across]
from = [0.5, 0.1]
to = [1.5, 0.1]
points = 21

[[support]]
from = [-1.5, -1.5]
to = [1.5, -1.5]
[[support]]
from = [1.5, -1.5]
to = [1.5, 1.5]
[[support]]
from = [1.5, 1.5]
to = [-1.5, 1.5]
[[support]]
from = [-1.5, 1.5]
to = [-1.5, -1.5]

# the hole: material that is at rest anyway, and would turn as a whole with the smallest error in torque
[[support]]
from = [0.5, -0.5]
to = [-0.5, -0.5]
[[support]]
from = [-0.5, -0.5]
to = [-0.5, 0.5]
[[support]]
from = [-0.5, 0.5]
to = [0.5, 0.5]
[[support]]
from = [0.5, 0.5]
to = [0.5, -0.5]

[motion] # ring 0.75 < R < 1.25, turned by g(t) h(R); duration: half the period, where the turn is largest
let = [
  "A = 1.0",
  "period = 1.0",
  "w = 2 * pi / period",
  "turn = A / 2 * (1 - cos(w * t))",
  "turn_rate = A / 2 * w * sin(w * t)",
  "turn_acceleration = A / 2 * w^2 * cos(w * t)",
  "R = sqrt(X^2 + Y^2)",
  "s = 16 * (R - 1)^2",
  "within = s < 1 ? 1 : 0",
  "h = within * (1 - s)^2",
  "h1 = within * (-64 * (R - 1) * (1 - s))",
  "h2 = within * (-64 * (1 - 3 * s))",
  "alpha = turn * h",
  "k = R > 0 ? 1 / R : 0",
  "er_x = k * (X * cos(alpha) - Y * sin(alpha))",
  "er_y = k * (X * sin(alpha) + Y * cos(alpha))",
  "a_r = -R * (turn_rate * h)^2",
  "a_t = R * turn_acceleration * h",
  "b_r = a_r + mu / rho * R * (turn * h1)^2",
  "b_t = a_t - mu / rho * turn * (3 * h1 + R * h2)",
  "shear = R * turn * h1",
]
displacement = ["X * cos(alpha) - Y * sin(alpha) - X", "X * sin(alpha) + Y * cos(alpha) - Y"]
velocity = ["-R * turn_rate * h * er_y", "R * turn_rate * h * er_x"]
acceleration = ["a_r * er_x - a_t * er_y", "a_r * er_y + a_t * er_x"]
body_force = ["b_r * er_x - b_t * er_y", "b_r * er_y + b_t * er_x"]
stress = [ # mu (b - I): in the turned frame b_rt = shear, b_tt = 1 + shear^2, b_rr = 1
  "mu * (-2 * shear * er_x * er_y + shear^2 * er_y^2)",
  "mu * (2 * shear * er_x * er_y + shear^2 * er_x^2)",
  "0",
  "mu * (shear * (er_x^2 - er_y^2) - shear^2 * er_x * er_y)",
]
duration = 0.5
)toml";

/// A wedge in one lift under its own weight: stress is linear in position, displacement follows by integrating Hooke's
/// law in plane strain. Apex at (0, 2), the middle of the base is held.
constexpr const char* single_lift_case = R"toml(
format = 1
title = "R3: a wedge in one lift under its own weight"
gravity = 10.0

[geometry]
shape = "polygons"
dimension = 2
[[geometry.polygon]]
corners = [[-3.0, 0.0], [0.0, 0.0], [0.0, 2.0]]
[[geometry.polygon]]
corners = [[0.0, 0.0], [3.0, 0.0], [0.0, 2.0]]

[material.soil]
law = "hencky"
youngs_modulus = 10e6
poissons_ratio = 0.3
density = 2000.0

[construction]
layers = 1
convention = "drop"
material = "soil"

[fem]
element_size = 0.25

[probes.across]
from = [0.3, 0.0]
to = [0.3, 1.7]
points = 18

[[support]]
from = [-3.0, 0.0]
to = [3.0, 0.0]
motion = "exact"

[motion] # apex at (0, 2), tan of half the apex angle 1.5; the middle of the base is held
let = [
  "T = 1.5^2",
  "d = 2.0 - Y",
  "gamma = rho * g",
  "a = gamma / (2 * E) * ((1 - nu^2) * T - nu * (1 + nu))",
  "b = gamma / (2 * E) * ((1 - nu^2) - nu * (1 + nu) * T)",
  "c = (1 + nu) * gamma / E",
]
displacement = ["-a * X * d", "(b * (d^2 - 4) + (c - a) * X^2) / 2"]
stress = ["-gamma * d * T / 2", "-gamma * d / 2", "-nu * gamma * d * (1 + T) / 2", "gamma * X / 2"]
)toml";

inline std::string fill_in_layers(int layers) {
  return fmt::format(R"(
gravity = 10.0
[material.soil]
law = "hencky"
youngs_modulus = 10e6
poissons_ratio = 0.3
density = 2000.0
[construction]
layers = {}
convention = "drop"
material = "soil"
[geometry]
shape = "polygons"
dimension = 2
)",
                     layers);
}

/// Half a wedge of layers parallel to its face, on a smooth base; apex at (0, 2), half apex angle 45 degrees. The
/// motion is exact as the layers get thin: of thickness 2/layers along the vertical.
inline std::string layered_wedge_case(int layers, double element_size) {
  std::string text = "format = 1\ntitle = \"wedge\"" + fill_in_layers(layers);
  for (int layer = 1; layer <= layers; ++layer) {
    const double low = 2.0 * (layer - 1) / layers, high = 2.0 * layer / layers;
    text += fmt::format("[[geometry.polygon]]\nlayer = {}\ncorners = [[{}, 0.0], [{}, 0.0], [0.0, {}]", layer, low,
                        high, high);
    text += layer == 1 ? "]\n" : fmt::format(", [0.0, {}]]\n", low);
  }
  return text + fmt::format("[fem]\nelement_size = {}\n", element_size) + R"toml(
[probes.across]
from = [0.3, 0.0]
to = [0.3, 1.7]
points = 18

[[support]]
from = [0.0, 0.0]
to = [2.0, 0.0]
held = "y"
[[support]]
from = [0.0, 2.0]
to = [0.0, 0.0]
held = "x"

[motion] # half apex angle 45 degrees; the layers' thickness along the vertical is 2/layers
let = ["gamma = rho * g", "cover = 2.0 * stage / layers - Y - X"]
displacement = ["nu * (1 + nu) * gamma * X * cover / E", "-(1 - nu^2) * gamma * Y * cover / E"]
stress = ["0", "-gamma * cover", "-nu * gamma * cover", "0"]
)toml";
}

/// A piece of an infinite slope of 0.5 rad that falls to the right, of layers parallel to it, 2 m long and 2 m high. n
/// is the height above the base at right angles to the slope; what is placed above a point after it is `loaded`, as in
/// a column, and acts along and across.
inline std::string slope_case(int layers, double element_size) {
  const auto corner = [](double along, double above) {
    const double cosine = std::cos(0.5), sine = std::sin(0.5);
    return fmt::format("[{:.17g}, {:.17g}]", along * cosine + above * sine, above * cosine - along * sine);
  };
  std::string text = "format = 1\ntitle = \"slope\"" + fill_in_layers(layers);
  for (int layer = 1; layer <= layers; ++layer) {
    const double low = 2.0 * (layer - 1) / layers, high = 2.0 * layer / layers;
    text += fmt::format("[[geometry.polygon]]\nlayer = {}\ncorners = [{}, {}, {}, {}]\n", layer, corner(0, low),
                        corner(2, low), corner(2, high), corner(0, high));
  }
  const auto support = [&](const std::string& from, const std::string& to) {
    text += fmt::format("[[support]]\nfrom = {}\nto = {}\nmotion = \"exact\"\n", from, to);
  };
  support(corner(0, 0), corner(2, 0));
  support(corner(2, 0), corner(2, 2));
  support(corner(0, 2), corner(0, 0));
  text += fmt::format("[fem]\nelement_size = {}\n[probes.middle]\nfrom = {}\nto = {}\npoints = 9\n", element_size,
                      corner(1, 0), corner(1, 2));
  return text + R"toml(
[motion] # slope of 0.5 rad that falls to the right; n: height above the base, at right angles to the slope
let = [
  "beta = 0.5",
  "thickness = 2.0 / layers",
  "n = X * sin(beta) + Y * cos(beta)",
  "base = (layer - 1) * thickness",
  "top = stage * thickness",
  "loaded = base * (top - base) + ((top - base)^2 - (top - n)^2) / 2",
  "gamma = rho * g",
  "settled = gamma * cos(beta) * loaded / (lambda + 2 * mu)",
  "crept = gamma * sin(beta) * loaded / mu",
  "depth = top - n",
  "sn = -gamma * depth * cos(beta)",
  "sl = nu / (1 - nu) * sn",
  "tau = gamma * depth * sin(beta)",
]
displacement = [
  "crept * cos(beta) - settled * sin(beta)",
  "-crept * sin(beta) - settled * cos(beta)",
]
stress = [
  "sl * cos(beta)^2 + sn * sin(beta)^2 + 2 * tau * sin(beta) * cos(beta)",
  "sl * sin(beta)^2 + sn * cos(beta)^2 - 2 * tau * sin(beta) * cos(beta)",
  "sl",
  "(sn - sl) * sin(beta) * cos(beta) + tau * (cos(beta)^2 - sin(beta)^2)",
]
)toml";
}

} // namespace settle::fem::testing
