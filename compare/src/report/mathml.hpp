/// \file
/// Formulas as cases write them (muParser's language), typeset as MathML Core, which browsers draw without any help.
#pragma once

#include <optional>
#include <string>

namespace settle::compare::report {

/// A formula, or an equation "name = formula": names of Greek letters become these letters, what follows "_" an index
/// (of several signs in braces: z_{k-1}), a quotient a fraction, "c ? a : b" a case distinction. Nothing where the text
/// is not understood.
std::optional<std::string> mathml_of(const std::string& formula);

} // namespace settle::compare::report
