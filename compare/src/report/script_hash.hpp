/// \file
/// The one script a page may run, as its content security policy names it.
#pragma once

#include <string>

namespace settle::compare::report {

/// SHA-256 of a script in base64.
std::string hash_of_script(const std::string& script);

} // namespace settle::compare::report
