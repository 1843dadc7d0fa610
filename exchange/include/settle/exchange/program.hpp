/// \file
/// What every program of the suite has in common: version, provenance, and errors turned into exit codes.
#pragma once

#include <functional>
#include <string>

#include "settle/exchange/errors.hpp"

namespace settle::exchange {

/// "0.1.0".
std::string program_version();
/// The commit this build was made from, with "-dirty" where the tree had changes; "unknown" outside a repository.
std::string program_commit();
/// Hexadecimal SHA-256 of a text.
std::string sha256(const std::string& text);
/// Now, in UTC, ISO 8601.
std::string utc_now();

/// How progress and errors are written: for people, or for programs as one JSON object a line.
enum class LogFormat { text, json };

/// Runs `body`, prints an Error's text as `NAME: text` to standard error, and returns the exit code. Any other
/// exception is reported as a defect of the program (exit code 70). With LogFormat::json the error is an object with
/// the keys event ("error"), program, exit_code and message.
int run_program(const std::string& name, const std::function<ExitCode()>& body, LogFormat format = LogFormat::text);

} // namespace settle::exchange
