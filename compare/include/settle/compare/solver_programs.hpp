/// \file
/// Where the solvers' programs are.
#pragma once

#include <filesystem>
#include <string>

namespace settle::compare {

/// "settle-mpm" for "mpm".
std::string program_name(const std::string& solver);
/// "SETTLE_MPM" for "mpm": the environment variable that names another program.
std::string program_variable(const std::string& solver);
/// A program beside the running one, else in PATH. Empty where there is none.
std::filesystem::path find_program(const std::string& name);
/// The program of a solver: what its environment variable names, else beside the running program, else in PATH.
/// Empty where there is none; a variable that names no file is not made up for by another place.
std::filesystem::path find_solver(const std::string& solver);

} // namespace settle::compare
