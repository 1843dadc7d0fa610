/// \file
/// What a solver hands over: plain data in the layout of the result file (docs/formats.md).
///
/// Vectors of points are row-major: `displacement[i * dim + c]`, `stress[i * 6 + c]` with components
/// xx yy zz xy yz xz, tension positive. In 2-D, masses, weights and volumes are per metre out of plane.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "settle/exchange/case.hpp"

namespace settle::exchange {

/// Native sample points of one stage: material points or quadrature points. n points, `dim` space dimensions.
struct SamplePoints {
  std::vector<std::uint64_t> id{};       ///< (n) stays with the point through all stages
  std::vector<std::int32_t> layer{};     ///< (n) 1 ... N
  std::vector<std::uint8_t> refilled{};  ///< (n) 1: added during a stage to make up for settlement
  std::vector<double> placed_position{}; ///< (n, dim) [m]
  std::vector<double> position{};        ///< (n, dim) [m]
  std::vector<double> displacement{};    ///< (n, dim) since placement [m]
  std::vector<double> stress{};          ///< (n, 6) Cauchy [Pa]
  std::vector<double> density{};         ///< (n) current [kg/m3]
  std::vector<double> volume{};          ///< (n) current [m3/m or m3]
  std::vector<double> plastic_strain{};  ///< (n) accumulated equivalent deviatoric [-]; empty where nothing yields
  std::vector<double> preconsolidation_pressure{}; ///< (n) of cam-clay [Pa]; empty where there is none

  [[nodiscard]] std::size_t size() const { return id.size(); }
};

/// One line of probes at one stage; only layers already placed. m points.
struct ProbeSamples {
  std::vector<std::int32_t> layer{};     ///< (m)
  std::vector<double> design_position{}; ///< (m, dim) in the design geometry [m]
  std::vector<double> placed_position{}; ///< (m, dim) [m]
  std::vector<double> displacement{};    ///< (m, dim) since placement [m]
  std::vector<double> stress{};          ///< (m, 6) Cauchy [Pa]

  [[nodiscard]] std::size_t size() const { return layer.size(); }
};

/// One stage of construction at its end.
struct Stage {
  int layer = 0;                  ///< the layer this stage placed, 1 ... N
  std::int64_t steps = 0;         ///< increments or time steps
  std::int64_t linear_solves = 0; ///< 0 for an explicit scheme
  double out_of_balance = 0;      ///< relative, of the last converged increment or step, before its points move [-]
  bool in_equilibrium = false;    ///< did the stage reach the equilibrium the case asks for
  double mass = 0;                ///< all mass present [kg/m or kg]
  double mass_placed = 0;         ///< placed at the start of this stage
  double mass_refilled = 0;       ///< added during this stage
  double weight = 0;              ///< full gravity on all mass present [N/m or N]
  double base_reaction = 0;       ///< positive upward [N/m or N]
  double surface_height = 0;      ///< points' volume over plan area; `drop`: highest point plus half its height [m]
  double wall_time = 0;           ///< [s]
  SamplePoints points{};
  std::map<std::string, ProbeSamples> probes{};
  std::vector<double> support_reactions{}; ///< (supports, dim) force on the body [N/m or N]; empty: not known
};

/// What became of a body that failed, where a solver goes on: from the state in equilibrium last, now with all of its
/// weight, to rest. Works and energies are per metre out of plane in 2-D and cover this way [J/m or J].
struct RunOut {
  bool at_rest = false;            ///< or only as far as the time allowed went
  double duration = 0;             ///< [s]
  double largest_displacement = 0; ///< of a point on this way [m]
  double distance = 0;             ///< of the farthest point beyond where the body ended before, along x [m]
  double mass_before = 0;          ///< [kg/m or kg]
  std::int64_t points_before = 0;
  double external_work = 0;  ///< of gravity and loads
  double stress_work = 0;    ///< stored and dissipated in the material
  double damping_loss = 0;   ///< taken by the scheme's damping
  double kinetic_energy = 0; ///< of the points: gained
  Stage state{};             ///< at the end

  /// What the other works and energies leave of the external work: dissipated by the scheme's own errors, or made.
  [[nodiscard]] double unaccounted() const { return external_work - stress_work - damping_loss - kinetic_energy; }
};

/// The stage that found no equilibrium, where a case may fail.
struct Failure {
  int stage = 0;    ///< 1 ... number of stages of the case
  double share = 0; ///< of it that was in equilibrium last, 0 ... 1; above 0, the result's last stage is that state
  std::optional<RunOut> run_out{}; ///< none: the solver ends there
};

/// The values the solver really used, for the driver to hold against the case.
struct Used {
  double youngs_modulus = 0;                  ///< [Pa]
  double poissons_ratio = 0;                  ///< [-]
  double density = 0;                         ///< as placed [kg/m3]
  double gravity = 0;                         ///< [m/s2]
  Law law = Law::rate;                        ///< the case's
  Kinematics kinematics = Kinematics::finite; ///< what was solved
  Convention convention = Convention::refill;
  int dimension = 2;
};

/// Where a result comes from.
struct Provenance {
  std::string solver{}; ///< "settle-mpm", "settle-fem", or another program's name
  std::string program_version{};
  std::string commit{};
  std::string case_sha256{}; ///< of the text under `/case`
  std::string created{};     ///< UTC, ISO 8601
  int threads = 1;
  double wall_time = 0; ///< [s]
};

/// A whole result file.
struct Result {
  Provenance provenance{};
  std::string case_text{}; ///< the case as read, overrides applied, defaults filled in (TOML)
  Used used{};
  std::vector<Stage> stages{};
  std::optional<Failure> failure{};
};

/// The values of `/used` as the case states them, to be overwritten by what the solver really used.
Used used_values(const Case& study, Kinematics solved);

} // namespace settle::exchange
