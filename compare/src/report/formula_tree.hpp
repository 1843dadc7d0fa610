/// \file
/// The structure of a formula: what is applied to what.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace settle::compare::report {

struct FormulaNode {
  enum class Kind { number, name, index, call, sign, binary, choice };
  Kind kind = Kind::number;
  std::string text{};             ///< number, name, function, or operator
  std::vector<FormulaNode> parts; ///< index: name and index; choice: condition and both values; operands, arguments
};

/// How strongly the outermost operator of a formula binds; what has none binds most.
int binding(const FormulaNode& node);

/// The tree of a formula in muParser's language, with indices in braces besides and "=" at the outermost level; nothing
/// where it is not understood.
std::optional<FormulaNode> formula_tree(const std::string& text);

} // namespace settle::compare::report
