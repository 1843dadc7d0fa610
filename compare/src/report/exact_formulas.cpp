#include "exact_formulas.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/compare/statistics.hpp"

namespace settle::compare::report {

namespace {

using exchange::Case;
using exchange::Convention;
using exchange::Kinematics;
using exchange::Law;

using Formulas = std::vector<Formula>;

void append(Formulas& formulas, const Formulas& more) {
  formulas.insert(formulas.end(), more.begin(), more.end());
}

FormulaGroup symbols_of_a_column() {
  return {"Symbols of the column",
          {{"gamma_0 = rho_0 * g", "unit weight as placed"},
           {"M = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu))", "constrained modulus: nothing strains sideways"},
           {"z_k = k * H / N", "design level of the top of layer k of N"}}};
}

Formulas of_law(Law law) {
  switch (law) {
  case Law::rate:
    return {{"sigma = M * ln(lambda)", "Cauchy stress of a vertical stretch λ, from the objective rate"},
            {"lambda(W) = exp(-W / M)", "stretch under the overburden W, as −σ = W"},
            {"Lambda(W) = M * (1 - exp(-W / M))", "integral of λ from no overburden to W"}};
  case Law::hencky:
    return {{"sigma = M * ln(lambda) / lambda", "Cauchy stress of a vertical stretch λ: Hencky's law"},
            {"w * exp(w) = W / M", "logarithmic compression w under the overburden W, as −σ = W"},
            {"lambda(W) = exp(-w)", "stretch under it"},
            {"Lambda(W) = M * (w + w^2 / 2)", "integral of λ from no overburden to W"}};
  case Law::neo_hookean:
    return {{"sigma = (lambda_L * ln(lambda) + mu * (lambda^2 - 1)) / lambda",
             "Cauchy stress of a vertical stretch λ; λ_L and μ are Lamé’s constants"},
            {"sigma(lambda(W)) = -W", "stretch under the overburden W, by root finding"},
            {"Lambda(W) = integral(lambda(w), w, 0, W)", "integral of λ from no overburden to W, by quadrature"}};
  default:
    break; // no closed form
  }
  return {};
}

Formulas of_convention(Convention convention) {
  const Formula height{"s_k = Lambda(B_k) / gamma_0", "height of the column after stage k"};
  switch (convention) {
  case Convention::refill:
    return {{"B_k = LambdaInverse(gamma_0 * z_k)",
             "weight per area of the column after stage k: as much as keeps its surface at the design level"},
            {"a_k = z_{k-1}", "a layer is placed at its design level"},
            {"h_k = H / N", "and with its design thickness"}};
  case Convention::level_up:
    return {{"B_k = B_{k-1} + gamma_0 * (z_k - s_{k-1})", "weight per area of the column after stage k"},
            height,
            {"a_k = s_{k-1}", "a layer is placed on the settled surface"},
            {"h_k = z_k - s_{k-1}", "and reaches up to its design level"}};
  case Convention::floating:
    return {{"B_k = B_{k-1} + gamma_0 * H / N", "weight per area of the column after stage k"},
            height,
            {"a_k = s_{k-1}", "a layer is placed on the settled surface"},
            {"h_k = H / N", "with its design thickness"}};
  case Convention::drop:
    return {{"B_k = B_{k-1} + gamma_0 * H / N", "weight per area of the column after stage k"},
            {"a_k = z_{k-1}", "a layer is placed at its design level"},
            {"h_k = H / N", "with its design thickness, and drops on the settled surface"}};
  }
  return {};
}

Formula lateral_stress(Law law) {
  const std::string meaning = "lateral stress";
  if (law == Law::neo_hookean) return {"sigma_h = lambda_L * ln(lambda) / lambda", meaning};
  return {"sigma_h = nu / (1 - nu) * sigma_v", meaning};
}

Formulas finite_column(const Case& study) {
  Formulas formulas = of_law(study.fill().law);
  append(formulas, of_convention(study.construction.convention));
  append(formulas, {{"W_j = B_j - B_{k-1} - gamma_0 * xi * h_k",
                     "overburden after stage j of the point at the share ξ of the height of layer k as placed"},
                    {"sigma_v = -W_j", "vertical stress: equilibrium is exact on mass"},
                    {"delta_j = a_k + xi * h_k - (Lambda(B_j) - Lambda(W_j)) / gamma_0",
                     "settlement since placement: placed height minus height now"},
                    lateral_stress(study.fill().law),
                    {"rho = rho_0 / lambda", "density"}});
  return formulas;
}

Formulas small_column() {
  return {{"delta_j = gamma_0 / M * (h * (z_j - z_{k-1}) - (h - z_{k-1})^2 / 2)",
           "settlement after stage j of the point of layer k at the height h: what its own layer and all later ones "
           "compress below it"},
          {"sigma_v = -gamma_0 * (z_j - h)", "vertical stress"},
          {"sigma_h = nu / (1 - nu) * sigma_v", "lateral stress"}};
}

/// The titles of the solvers that solve with these kinematics.
std::vector<std::string> solvers_of(const RunOutcome& run, Kinematics kinematics) {
  std::vector<std::string> titles;
  for (const SolverRun& solver : run.solvers)
    if (kinematics_solved(run, solver.solver) == kinematics) titles.push_back(title_of(solver));
  return titles;
}

std::vector<FormulaGroup> of_a_column(const RunOutcome& run) {
  std::vector<FormulaGroup> groups{symbols_of_a_column()};
  const auto finite = solvers_of(run, Kinematics::finite), small = solvers_of(run, Kinematics::small);
  if (!finite.empty())
    groups.push_back(
        {fmt::format("Finite strain, law “{}”, built by “{}”: what {} solves", name_of(run.study.fill().law),
                     name_of(run.study.construction.convention), fmt::join(finite, " and ")),
         finite_column(run.study)});
  if (!small.empty())
    groups.push_back({fmt::format("Small strain: what {} solves", fmt::join(small, " and ")), small_column()});
  return groups;
}

/// Formulas of components, each with its name.
void add_components(const std::vector<std::string>& names, const std::vector<std::string>& formulas,
                    const std::string& meaning, Formulas& all) {
  for (std::size_t i = 0; i < std::min(names.size(), formulas.size()); ++i)
    all.push_back({names[i] + " = " + formulas[i], i == 0 ? meaning : ""});
}

std::vector<FormulaGroup> of_a_motion(const exchange::Motion& motion) {
  Formulas known, driven, abbreviations;
  add_components({"u_x", "u_y"}, motion.displacement, "displacement since placement [m]", known);
  add_components({"sigma_xx", "sigma_yy", "sigma_zz", "tau_xy"}, motion.stress, "Cauchy stress, tension positive [Pa]",
                 known);
  add_components({"v_x", "v_y"}, motion.velocity, "velocity [m/s]", driven);
  add_components({"a_x", "a_y"}, motion.acceleration, "acceleration [m/s²]", driven);
  add_components({"b_x", "b_y"}, motion.body_force, "body force per mass besides gravity [m/s²]", driven);
  for (const std::string& text : motion.let)
    abbreviations.push_back({text, ""});
  std::vector<FormulaGroup> groups{{"What the case states to be exact of the point placed at (X, Y)", known}};
  if (!driven.empty()) groups.push_back({"Its motion in time, and what drives it", driven});
  if (!abbreviations.empty())
    groups.push_back(
        {"Abbreviations; λ and μ are Lamé’s constants, layer is the point’s, stage counts the layers placed",
         abbreviations});
  return groups;
}

} // namespace

std::vector<FormulaGroup> exact_formulas(const RunOutcome& run) {
  if (run.study.geometry.shape == exchange::Shape::column) return of_a_column(run);
  return run.study.motion ? of_a_motion(*run.study.motion) : std::vector<FormulaGroup>{};
}

} // namespace settle::compare::report
