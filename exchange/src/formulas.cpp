#include "settle/exchange/formulas.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include "settle/exchange/assert.hpp"
#include "settle/exchange/errors.hpp"
#include "settle/exchange/spelling.hpp"

namespace settle::exchange {
namespace {

/// The values behind the names that every formula knows.
struct Variables {
  double x = 0, y = 0, time = 0, layer = 1, stage = 1;
};

struct Constant {
  std::string name;
  double value;
};

std::vector<Constant> constants_of(const Case& study) {
  const Material& fill = study.fill();
  const double mu = fill.youngs_modulus / (2 * (1 + fill.poissons_ratio));
  return {{"layers", static_cast<double>(study.construction.layers)},
          {"E", fill.youngs_modulus},
          {"nu", fill.poissons_ratio},
          {"rho", fill.density},
          {"g", study.gravity},
          {"lambda", 2 * mu * fill.poissons_ratio / (1 - 2 * fill.poissons_ratio)},
          {"mu", mu},
          {"cohesion", fill.cohesion.value_or(0.0)},
          {"friction_angle", fill.friction_angle.value_or(0.0) * std::numbers::pi / 180.0},
          {"pi", std::numbers::pi}};
}

/// "name = formula" taken apart; nothing where it is not of that form.
struct Definition {
  std::string name, formula;
};
std::optional<Definition> definition_of(const std::string& text) {
  const auto sign = text.find('=');
  if (sign == std::string::npos || text.substr(sign, 2) == "==") return {};
  const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ', sign - 1);
  if (first >= sign || last == std::string::npos) return {};
  Definition definition{text.substr(first, last - first + 1), text.substr(sign + 1)};
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  if (!is_letter(definition.name.front())) return {};
  for (const char c : definition.name)
    if (!is_letter(c) && std::isdigit(static_cast<unsigned char>(c)) == 0) return {};
  return definition;
}

} // namespace

/// Every formula is a parser of its own. The abbreviations are evaluated in their order before it, at each point anew,
/// those before the last one that it needs.
struct Formulas::Implementation {
  /// One formula, compiled, and how many of the abbreviations it may need.
  struct Formula {
    std::unique_ptr<mu::Parser> parser;
    std::size_t abbreviations = 0;
  };
  using List = std::vector<Formula>;

  explicit Implementation(const Case& study) : constants(constants_of(study)), values(study.motion->let.size()) {
    const Motion& motion = *study.motion;
    for (std::size_t i = 0; i < motion.let.size(); ++i)
      define(study, motion.let[i], fmt::format("motion.let.{}", i));
    displacement = compiled(study, motion.displacement, "motion.displacement");
    stress = compiled(study, motion.stress, "motion.stress");
    velocity = compiled(study, motion.velocity, "motion.velocity");
    acceleration = compiled(study, motion.acceleration, "motion.acceleration");
    body_force = compiled(study, motion.body_force, "motion.body_force");
  }

  std::vector<Constant> constants;
  Variables variables;
  std::vector<std::string> names; ///< of the abbreviations
  std::vector<double> values;     ///< theirs; never resized, parsers point into it
  List abbreviations;
  List displacement, stress, velocity, acceleration, body_force;

  void define(const Case& study, const std::string& text, const std::string& key) {
    const auto definition = definition_of(text);
    if (!definition)
      throw InputError({.where = study.where(key),
                        .what = key + " is no abbreviation",
                        .given = text,
                        .allowed = "name = formula, the name of letters, digits and _",
                        .remedy = {}});
    for (const std::string& known : known_names())
      if (known == definition->name)
        throw InputError({.where = study.where(key),
                          .what = fmt::format("{} gives a second meaning to {}", key, known),
                          .given = text,
                          .allowed = "a name of your own",
                          .remedy = fmt::format("call it {}_1", known)});
    abbreviations.push_back(compile(study, definition->formula, key));
    names.push_back(definition->name);
  }

  [[nodiscard]] std::vector<std::string> known_names() const {
    std::vector<std::string> known{"X", "Y", "t", "layer", "stage"};
    for (const Constant& constant : constants)
      known.push_back(constant.name);
    known.insert(known.end(), names.begin(), names.end());
    return known;
  }

  List compiled(const Case& study, const std::vector<std::string>& formulas, const std::string& key) {
    List list;
    for (std::size_t i = 0; i < formulas.size(); ++i)
      list.push_back(compile(study, formulas[i], fmt::format("{}.{}", key, i)));
    return list;
  }

  Formula compile(const Case& study, const std::string& text, const std::string& key) {
    Formula formula{std::make_unique<mu::Parser>(), 0};
    mu::Parser& parser = *formula.parser;
    try {
      parser.DefineVar("X", &variables.x);
      parser.DefineVar("Y", &variables.y);
      parser.DefineVar("t", &variables.time);
      parser.DefineVar("layer", &variables.layer);
      parser.DefineVar("stage", &variables.stage);
      for (const Constant& constant : constants)
        parser.DefineConst(constant.name, constant.value);
      for (std::size_t i = 0; i < names.size(); ++i)
        parser.DefineVar(names[i], &values[i]);
      parser.SetExpr(text);
      for (const auto& [name, address] : parser.GetUsedVar()) // throws where a name is unknown
        for (std::size_t i = 0; i < names.size(); ++i)
          if (names[i] == name) formula.abbreviations = std::max(formula.abbreviations, i + 1);
      static_cast<void>(parser.Eval());
      if (parser.GetNumResults() != 1) throw mu::Parser::exception_type("one formula, not several with commas");
    } catch (const mu::Parser::exception_type& error) {
      refuse(study, text, key, error);
    }
    return formula;
  }

  [[noreturn]] void refuse(const Case& study, const std::string& text, const std::string& key,
                           const mu::Parser::exception_type& error) const {
    const auto nearest = nearest_spelling(error.GetToken(), known_names());
    throw InputError({.where = study.where(key),
                      .what = fmt::format("{} cannot be understood: {}", key, error.GetMsg()),
                      .given = text,
                      .allowed = fmt::format("a formula of {} and the usual functions", fmt::join(known_names(), ", ")),
                      .remedy = nearest && error.GetCode() == mu::ecUNASSIGNABLE_TOKEN
                                    ? fmt::format("did you mean {}?", *nearest)
                                    : std::string()});
  }

  template <std::size_t n>
  std::array<double, n> evaluate(const List& list, const FormulaPoint& at, double where_none) {
    std::array<double, n> result;
    result.fill(where_none);
    if (list.empty()) return result;
    SETTLE_ASSERT(list.size() == n, list.size());
    variables = {at.x, at.y, at.time, static_cast<double>(at.layer), static_cast<double>(at.stage)};
    std::size_t needed = 0;
    for (const Formula& formula : list)
      needed = std::max(needed, formula.abbreviations);
    for (std::size_t i = 0; i < needed; ++i)
      values[i] = abbreviations[i].parser->Eval();
    for (std::size_t i = 0; i < n; ++i)
      result[i] = list[i].parser->Eval();
    return result;
  }
};

Formulas::Formulas(const Case& study) : implementation_(std::make_unique<Implementation>(study)) {}
Formulas::Formulas(Formulas&&) noexcept = default;
Formulas& Formulas::operator=(Formulas&&) noexcept = default;
Formulas::~Formulas() = default;

std::array<double, 2> Formulas::displacement(const FormulaPoint& at) const {
  return implementation_->evaluate<2>(implementation_->displacement, at, 0.0);
}

std::array<double, 4> Formulas::stress(const FormulaPoint& at) const {
  return implementation_->evaluate<4>(implementation_->stress, at, std::numeric_limits<double>::quiet_NaN());
}

std::array<double, 2> Formulas::velocity(const FormulaPoint& at) const {
  return implementation_->evaluate<2>(implementation_->velocity, at, 0.0);
}

std::array<double, 2> Formulas::acceleration(const FormulaPoint& at) const {
  return implementation_->evaluate<2>(implementation_->acceleration, at, 0.0);
}

std::array<double, 2> Formulas::body_force(const FormulaPoint& at) const {
  return implementation_->evaluate<2>(implementation_->body_force, at, 0.0);
}

bool Formulas::has_stress() const {
  return !implementation_->stress.empty();
}

double value_of(const Case& study, const std::string& formula, const std::string& key) {
  const auto refuse = [&](const std::string& why) {
    throw InputError({.where = study.where(key),
                      .what = fmt::format("{} cannot be understood: {}", key, why),
                      .given = formula,
                      .allowed = "a formula of numbers, layers, E, nu, rho, g, lambda, mu, cohesion, friction_angle "
                                 "[rad], pi and the usual functions, with a finite value",
                      .remedy = {}});
  };
  mu::Parser parser;
  double value = 0;
  try {
    for (const Constant& constant : constants_of(study))
      parser.DefineConst(constant.name, constant.value);
    parser.SetExpr(formula);
    value = parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    refuse(error.GetMsg());
  }
  if (!std::isfinite(value)) refuse("it has no finite value");
  return value;
}

} // namespace settle::exchange
