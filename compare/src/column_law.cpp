#include "settle/compare/column_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/lambert_w.hpp>
#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

#include "settle/exchange/errors.hpp"

namespace settle::compare {
namespace {

using exchange::Law;

constexpr int root_bits = 50;
constexpr std::uintmax_t root_iterations = 200;

/// Root of a monotonic function that changes sign in [low, high], to nearly the last bit.
template <class Function>
double bracketed_root(const Function& function, double low, double high) {
  std::uintmax_t iterations = root_iterations;
  const auto bounds = boost::math::tools::toms748_solve(
      function, low, high, boost::math::tools::eps_tolerance<double>(root_bits), iterations);
  return 0.5 * (bounds.first + bounds.second);
}

[[noreturn]] void throw_no_equilibrium(Law law, double integral, double modulus) {
  throw exchange::InputError({.where = "exact column",
                              .what = "no equilibrium exists: the fill cannot be kept at its design height",
                              .given = fmt::format("unit weight times height {:.6g} Pa, constrained modulus {:.6g} Pa, "
                                                   "law \"{}\"",
                                                   integral, modulus, exchange::name_of(law)),
                              .allowed = "unit weight times height below the constrained modulus",
                              .remedy = "take a stiffer or lighter material, or a lower column"});
}

} // namespace

ColumnLaw::ColumnLaw(const exchange::Material& material) : law_(material.law) {
  if (law_ > Law::neo_hookean)
    throw exchange::InputError({.where = "exact column",
                                .what = "no closed form is known of a column of this law",
                                .given = fmt::format("law \"{}\"", exchange::name_of(law_)),
                                .allowed = "\"rate\", \"hencky\" or \"neo-hookean\"",
                                .remedy = "compare solvers with each other"});
  const double nu = material.poissons_ratio;
  lame_mu_ = material.youngs_modulus / (2.0 * (1.0 + nu));
  lame_lambda_ = material.youngs_modulus * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
  modulus_ = lame_lambda_ + 2.0 * lame_mu_;
}

double ColumnLaw::stretch(double overburden) const {
  switch (law_) {
  case Law::rate:
    return std::exp(-overburden / modulus_);
  case Law::hencky: // W0(x) / x = exp(-W0(x)), also at x = 0
    return std::exp(-boost::math::lambert_w0(overburden / modulus_));
  case Law::neo_hookean:
    return std::exp(solve_strain(overburden));
  default:
    break; // the constructor refuses other laws
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double ColumnLaw::integral(double overburden) const {
  switch (law_) {
  case Law::rate:
    return -modulus_ * std::expm1(-overburden / modulus_);
  case Law::hencky: {
    const double w = boost::math::lambert_w0(overburden / modulus_);
    return modulus_ * (w + 0.5 * w * w);
  }
  case Law::neo_hookean: {
    // dw = -(dsigma/de) de with the logarithmic strain e: exact also where strains are small
    const auto integrand = [this](double strain) {
      const double stretch = std::exp(strain);
      return stretch * stretch * vertical_tangent(stretch);
    };
    using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
    return Rule::integrate(integrand, solve_strain(overburden), 0.0, 10, 1e-14);
  }
  default:
    break; // the constructor refuses other laws
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double ColumnLaw::inverse_integral(double integral) const {
  switch (law_) {
  case Law::rate:
    if (integral >= modulus_) throw_no_equilibrium(law_, integral, modulus_);
    return -modulus_ * std::log1p(-integral / modulus_);
  case Law::hencky: {
    const double twice = 2.0 * integral / modulus_;
    const double w = twice / (1.0 + std::sqrt(1.0 + twice)); // sqrt(1 + twice) - 1 without cancellation
    return modulus_ * w * std::exp(w);
  }
  case Law::neo_hookean:
    return solve_inverse(integral);
  default:
    break; // the constructor refuses other laws
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double ColumnLaw::lateral_stress(double overburden) const {
  switch (law_) {
  case Law::rate:
  case Law::hencky:
    return -overburden * lame_lambda_ / modulus_;
  case Law::neo_hookean: {
    const double strain = solve_strain(overburden);
    return lame_lambda_ * strain / std::exp(strain);
  }
  default:
    break; // the constructor refuses other laws
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double ColumnLaw::vertical_stress(double stretch) const {
  return stress_at(std::log(stretch));
}

double ColumnLaw::stress_at(double strain) const {
  switch (law_) {
  case Law::rate:
    return modulus_ * strain;
  case Law::hencky:
    return modulus_ * strain / std::exp(strain);
  case Law::neo_hookean:
    return (lame_lambda_ * strain + lame_mu_ * std::expm1(2.0 * strain)) / std::exp(strain);
  default:
    break; // the constructor refuses other laws
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double ColumnLaw::vertical_tangent(double stretch) const {
  switch (law_) {
  case Law::rate:
    return modulus_ / stretch;
  case Law::hencky:
    return modulus_ * (1.0 - std::log(stretch)) / (stretch * stretch);
  case Law::neo_hookean:
    return lame_lambda_ * (1.0 - std::log(stretch)) / (stretch * stretch) +
           lame_mu_ * (1.0 + 1.0 / (stretch * stretch));
  default:
    break; // the constructor refuses other laws
  }
  return std::numeric_limits<double>::quiet_NaN();
}

double ColumnLaw::solve_strain(double overburden) const {
  if (overburden == 0.0) return 0.0;
  const auto imbalance = [this, overburden](double strain) { return stress_at(strain) + overburden; };
  double end = -overburden / modulus_; // the linear solution
  while (overburden > 0.0 ? imbalance(end) > 0.0 : imbalance(end) < 0.0)
    end *= 2.0;
  return bracketed_root(imbalance, std::min(end, 0.0), std::max(end, 0.0));
}

double ColumnLaw::solve_inverse(double integral) const {
  if (integral <= 0.0) return integral;
  const auto excess = [this, integral](double overburden) { return this->integral(overburden) - integral; };
  double high = 2.0 * integral; // stretch <= 1 under compression, so W >= Lambda(W)
  constexpr int doublings = 200;
  for (int i = 0; excess(high) < 0.0; ++i) {
    if (i == doublings) throw_no_equilibrium(law_, integral, modulus_);
    high *= 2.0;
  }
  return bracketed_root(excess, integral, high);
}

} // namespace settle::compare
