#include "mathml.hpp"

#include <map>

#include <fmt/format.h>

#include "chart_frame.hpp"
#include "formula_tree.hpp"

namespace settle::compare::report {

namespace {

using Kind = FormulaNode::Kind;

std::string typeset(const FormulaNode& node);

std::string tag(const char* name, const std::string& content) {
  return fmt::format("<{0}>{1}</{0}>", name, content);
}

std::string sign(const std::string& text) {
  return tag("mo", text);
}

std::string row(const FormulaNode& node) {
  return tag("mrow", typeset(node));
}

std::string in_parentheses(const FormulaNode& node) {
  return tag("mrow", sign("(") + typeset(node) + sign(")"));
}

/// An operand, in parentheses where it binds less than it is held.
std::string operand(const FormulaNode& node, int held) {
  return binding(node) < held ? in_parentheses(node) : typeset(node);
}

/// The sign of a Greek letter by its name; empty for any other name.
std::string greek(const std::string& name) {
  static const std::map<std::string, std::string> letters{
      {"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"},  {"delta", "δ"},  {"eps", "ε"}, {"epsilon", "ε"}, {"eta", "η"},
      {"theta", "θ"}, {"kappa", "κ"}, {"lambda", "λ"}, {"Lambda", "Λ"}, {"mu", "μ"},  {"nu", "ν"},      {"xi", "ξ"},
      {"pi", "π"},    {"rho", "ρ"},   {"sigma", "σ"},  {"tau", "τ"},    {"phi", "φ"}, {"omega", "ω"}};
  const auto found = letters.find(name);
  return found != letters.end() ? found->second : std::string();
}

std::string letter(const std::string& name) {
  const std::string sign = greek(name);
  return tag("mi", sign.empty() ? escaped(name) : sign);
}

/// "1.5e-3" as 1.5 · 10⁻³.
std::string number(const std::string& text) {
  const std::size_t at = text.find_first_of("eE");
  if (at == std::string::npos) return tag("mn", text);
  const int power = std::stoi(text.substr(at + 1));
  const std::string exponent = (power < 0 ? sign("−") : "") + tag("mn", std::to_string(std::abs(power)));
  return tag("mrow", tag("mn", text.substr(0, at)) + sign("⋅") + tag("msup", tag("mn", "10") + tag("mrow", exponent)));
}

/// A name of one sign needs no dot beside it; words and numbers do.
bool is_short(const FormulaNode& node) {
  if (node.kind == Kind::index) return is_short(node.parts[0]);
  if (node.kind == Kind::name) return node.text.size() == 1 || !greek(node.text).empty();
  return node.kind == Kind::binary && node.text == "^" && is_short(node.parts[0]);
}

std::string product(const FormulaNode& node) {
  const FormulaNode& left = node.parts[0];
  const FormulaNode& right = node.parts[1];
  // The last factor of a product at the left is what stands beside the right.
  const FormulaNode& last = left.kind == Kind::binary && left.text == "*" ? left.parts[1] : left;
  const FormulaNode& beside = last.kind == Kind::sign ? last.parts[0] : last;
  const bool closed = is_short(beside) || binding(beside) < binding(node) || beside.text == "/";
  const bool after_number = beside.kind == Kind::number && right.kind != Kind::number;
  const bool joined = (closed || after_number) && (is_short(right) || binding(right) < binding(node));
  return operand(left, binding(node)) + sign(joined ? "\u2062" : "⋅") + operand(right, binding(node) + 1);
}

/// A function is raised as a whole: sin(x)^2; whatever binds less than a name stands in parentheses.
std::string power(const FormulaNode& node) {
  const bool is_simple =
      node.parts[0].kind != Kind::binary && node.parts[0].kind != Kind::sign && node.parts[0].kind != Kind::choice;
  const std::string base = is_simple ? row(node.parts[0]) : in_parentheses(node.parts[0]);
  return tag("msup", base + row(node.parts[1]));
}

std::string binary(const FormulaNode& node) {
  static const std::map<std::string, std::string> signs{{"-", "−"},  {"<", "&lt;"}, {">", "&gt;"},
                                                        {"<=", "≤"}, {">=", "≥"},   {"==", "="},
                                                        {"!=", "≠"}, {"&&", "and"}, {"||", "or"}};
  if (node.text == "*") return product(node);
  if (node.text == "/") return tag("mfrac", row(node.parts[0]) + row(node.parts[1]));
  if (node.text == "^") return power(node);
  const auto found = signs.find(node.text);
  return operand(node.parts[0], binding(node)) + sign(found != signs.end() ? found->second : node.text) +
         operand(node.parts[1], binding(node) + 1);
}

/// integral(what, over, from, to)
std::string integral(const FormulaNode& node) {
  return tag("mrow", tag("msubsup", sign("∫") + row(node.parts[3]) + row(node.parts[4])) + typeset(node.parts[1]) +
                         tag("mi", "d") + typeset(node.parts[2]));
}

std::string call(const FormulaNode& node) {
  const FormulaNode& function = node.parts[0];
  if (function.text == "sqrt" && node.parts.size() == 2) return tag("msqrt", typeset(node.parts[1]));
  if (function.text == "abs" && node.parts.size() == 2)
    return tag("mrow", sign("|") + typeset(node.parts[1]) + sign("|"));
  if (function.text == "integral" && node.parts.size() == 5) return integral(node);
  std::string arguments;
  for (std::size_t i = 1; i < node.parts.size(); ++i)
    arguments += (i > 1 ? sign(",") : "") + typeset(node.parts[i]);
  const std::string name = function.text == "LambdaInverse"
                               ? tag("msup", letter("Lambda") + tag("mrow", sign("−") + tag("mn", "1")))
                               : typeset(function);
  return tag("mrow", name + sign("\u2061") + tag("mrow", sign("(") + arguments + sign(")")));
}

/// value if condition; other value otherwise
std::string choice(const FormulaNode& node) {
  const auto line = [](const std::string& value, const std::string& when) {
    return tag("mtr", tag("mtd", value) + tag("mtd", when));
  };
  const std::string lines = line(typeset(node.parts[1]), tag("mtext", "if\u00a0") + typeset(node.parts[0])) +
                            line(typeset(node.parts[2]), tag("mtext", "otherwise"));
  return tag("mrow", sign("{") + tag("mtable", lines));
}

std::string typeset(const FormulaNode& node) {
  switch (node.kind) {
  case Kind::number:
    return number(node.text);
  case Kind::name:
    return letter(node.text);
  case Kind::index:
    return tag("msub", typeset(node.parts[0]) + row(node.parts[1]));
  case Kind::call:
    return call(node);
  case Kind::sign:
    return sign(node.text == "-" ? "−" : node.text == "!" ? "¬" : node.text) + operand(node.parts[0], binding(node));
  case Kind::binary:
    return binary(node);
  case Kind::choice:
    return choice(node);
  }
  return {};
}

} // namespace

std::optional<std::string> mathml_of(const std::string& formula) {
  const std::optional<FormulaNode> tree = formula_tree(formula);
  if (!tree) return {};
  return fmt::format(R"(<math display="block" alttext="{}">{}</math>)", escaped(formula), typeset(*tree));
}

} // namespace settle::compare::report
