/// \file
/// Solvers that files join by a command: any program that reads a case and writes a result (docs/adding-a-solver.md).
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "settle/exchange/case.hpp"
#include "settle/exchange/key_table.hpp"

namespace settle::compare {

/// A table `[solver.NAME]`.
struct JoinedSolver {
  std::string command; ///< once read: its words quoted, {here} filled in; {case} and {result} stand for two files
  std::string title;   ///< what reports call it; empty: its name
  std::optional<exchange::Kinematics> kinematics; ///< what it has to have solved; empty: whatever it says it solved
  std::string note;                               ///< shown by `settle list` and in the report
};

using JoinedSolvers = std::map<std::string, JoinedSolver>;

exchange::KeyTable<JoinedSolver> joined_solver_keys();

/// Checks names and commands that were just read from `file`, and fills in {here}, the file's folder.
void settle_commands(const std::filesystem::path& file, JoinedSolvers& solvers, exchange::Reading& reading);

/// A file of solvers. Throws InputError with file:line:column for what is wrong with it.
JoinedSolvers read_solvers(const std::filesystem::path& file);

/// The user's own solvers: $SETTLE_SOLVERS, else solvers.toml in settle's folder of $XDG_CONFIG_HOME or ~/.config,
/// where nothing needs to be. Throws InputError.
JoinedSolvers user_solvers();

/// JSON Schema (draft-07) of such a file.
std::string solvers_schema();

/// "mpm", "fem" and the joined ones.
std::vector<std::string> solver_names(const JoinedSolvers& joined);

/// What to say of a solver that is none of `known`, which `user` ("run.0.solvers") names; nothing where it is one.
std::optional<exchange::Complaint> unknown_solver(const std::string& solver, const std::vector<std::string>& known,
                                                  const std::string& where, const std::string& user);

/// The words of a joined solver's command for one case and result.
std::vector<std::string> words_of(const JoinedSolver& solver, const std::filesystem::path& case_file,
                                  const std::filesystem::path& result_file);

/// The program that a command starts: the file named, or the one beside settle or in PATH. Empty where there is none.
std::filesystem::path program_of(const JoinedSolver& solver);

/// What the results of a joined solver depend on besides the case: its command, and the content of the program and of
/// every file that a word of the command names, a script for instance. Throws FileError where one cannot be read.
std::string key_of(const JoinedSolver& solver);

} // namespace settle::compare
