/// \file
/// The command line that every solver of the suite has: NAME CASE --out RESULT.h5 [--set key=value] [--check]
/// [--quiet] [--log-format text|json]; or NAME --check --cases LIST.json.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "settle/exchange/result.hpp"

namespace CLI {
class App;
}

namespace settle::exchange {

/// Takes a stage's result.
using StageSink = std::function<void(const Stage&)>;

/// What makes one solver differ from another.
struct SolverProgram {
  std::string name;        ///< "settle-mpm"
  std::string description; ///< one line
  std::string libraries;   ///< what it is built on, for --version
  /// Adds options of the solver's own; may be empty.
  std::function<void(CLI::App&)> declare_options;
  /// Throws InputError where the case cannot be run; returns a clause on what would be run ("5 layers, 80 cells").
  std::function<std::string(const Case&)> check;
  /// What the solver really uses.
  std::function<Used(const Case&)> used;
  /// How many threads the case is run with; may be empty: one.
  std::function<int(const Case&)> threads;
  /// Runs the case, handing over every stage at its end.
  /// Returns where the body failed, if the case allows that and it did; throws NotConverged if the case does not.
  std::function<std::optional<Failure>(const Case&, const StageSink&)> solve;
};

/// Parses the command line, reads and checks the case, runs it, writes the result. Returns the program's exit code.
int run_solver(const SolverProgram& program, int argc, char** argv);

} // namespace settle::exchange
