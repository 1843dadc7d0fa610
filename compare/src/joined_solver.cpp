#include "settle/compare/joined_solver.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settle/compare/command_words.hpp"
#include "settle/compare/solver_programs.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/spelling.hpp"

namespace settle::compare {

namespace fs = std::filesystem;
namespace document = exchange::document;

namespace {

/// A solvers file of the user.
struct SolversFile {
  int format = 1;
  JoinedSolvers solvers;
};

exchange::KeyTable<SolversFile> solvers_file_keys() {
  exchange::KeyTable<SolversFile> keys("Solvers that every campaign of a user may name.");
  keys.integer("format", &SolversFile::format,
               {.range = exchange::exactly(1), .required = true, .doc = "version of this format"});
  keys.named_tables("solver", &SolversFile::solvers, joined_solver_keys());
  return keys;
}

std::string with(std::string text, std::string_view placeholder, const std::string& value) {
  for (std::size_t at = text.find(placeholder); at != std::string::npos; at = text.find(placeholder, at + value.size()))
    text.replace(at, placeholder.size(), value);
  return text;
}

std::string place_of(const exchange::Reading& reading, const std::string& key, const fs::path& file) {
  const auto origin = reading.origins().find(key);
  return origin != reading.origins().end() ? origin->second : file.string();
}

void check_name(const std::string& name, const std::string& where, exchange::Reading& reading) {
  constexpr std::array<std::string_view, 5> reserved{"mpm", "fem", "exact", "eq-1", "baseline"};
  const bool taken = std::find(reserved.begin(), reserved.end(), name) != reserved.end() || name.starts_with("exact-");
  if (!taken) return;
  reading.complain({.where = where,
                    .what = fmt::format("solver.{} has a name with a meaning of its own", name),
                    .given = name,
                    .allowed = fmt::format("any name but {}, exact-...", fmt::join(reserved, ", ")),
                    .remedy = {}});
}

void check_placeholders(const std::string& name, const std::string& command, const std::string& where,
                        exchange::Reading& reading) {
  for (const std::string placeholder : {"{case}", "{result}"}) {
    if (command.find(placeholder) != std::string::npos) continue;
    reading.complain({.where = where,
                      .what = fmt::format("the command of solver.{} does not say where {} goes", name, placeholder),
                      .given = command,
                      .allowed = "a command with {case}, the case file, and {result}, the HDF5 file to be written",
                      .remedy = "for example command = \"my-code {case} --out {result}\""});
  }
}

/// The command with {here} filled in, every word quoted where it needs to be.
std::string settled(const std::string& command, const std::string& where, const fs::path& here) {
  std::vector<std::string> words = split_command(command, where);
  for (std::string& word : words)
    word = with(std::move(word), "{here}", here.string());
  return joined(words);
}

fs::path default_file() {
  const auto variable = [](const char* name) { return std::getenv(name); };
  const char* configuration = variable("XDG_CONFIG_HOME");
  if (configuration != nullptr && *configuration != '\0') return fs::path(configuration) / "settle" / "solvers.toml";
  const char* home = variable("HOME");
  return home != nullptr ? fs::path(home) / ".config" / "settle" / "solvers.toml" : fs::path();
}

} // namespace

exchange::KeyTable<JoinedSolver> joined_solver_keys() {
  exchange::KeyTable<JoinedSolver> keys("A program that joins as a solver; NAME is what runs and checks call it.");
  keys.text("command", &JoinedSolver::command,
            {.required = true,
             .doc = "run without a shell: {case} is the case file, {result} the HDF5 file to be written, {here} the "
                    "folder of the file this stands in"});
  keys.text("title", &JoinedSolver::title, {.left_out = "NAME", .doc = "what reports call it"});
  keys.choice("kinematics", &JoinedSolver::kinematics,
              {.left_out = "what the result says", .doc = "what it must have solved"});
  keys.text("note", &JoinedSolver::note, {.doc = "what it is, where it comes from"});
  return keys;
}

void settle_commands(const fs::path& file, JoinedSolvers& solvers, exchange::Reading& reading) {
  const fs::path here = file.empty() ? fs::current_path() : fs::absolute(file).lexically_normal().parent_path();
  for (auto& [name, solver] : solvers) {
    check_name(name, place_of(reading, "solver." + name, file), reading);
    if (solver.command.empty()) continue; // its absence has been complained about
    const std::string where = place_of(reading, "solver." + name + ".command", file);
    check_placeholders(name, solver.command, where, reading);
    solver.command = settled(solver.command, where, here);
  }
}

JoinedSolvers read_solvers(const fs::path& file) {
  exchange::Reading reading;
  SolversFile content;
  solvers_file_keys().read(document::read(file), {.path = "", .where = file.string()}, content, reading);
  settle_commands(file, content.solvers, reading);
  reading.throw_if_any();
  return content.solvers;
}

JoinedSolvers user_solvers() {
  const char* named = std::getenv("SETTLE_SOLVERS");
  if (named != nullptr && *named != '\0') return read_solvers(named);
  const fs::path file = default_file();
  std::error_code failure;
  return fs::exists(file, failure) ? read_solvers(file) : JoinedSolvers();
}

std::string solvers_schema() {
  document::Table schema = solvers_file_keys().schema();
  schema.insert(schema.begin(), {"$schema", {}, {std::string("http://json-schema.org/draft-07/schema#"), {}}});
  return document::to_json({std::move(schema), {}});
}

std::vector<std::string> solver_names(const JoinedSolvers& joined) {
  std::vector<std::string> names{"mpm", "fem"};
  for (const auto& [name, solver] : joined)
    names.push_back(name);
  return names;
}

std::optional<exchange::Complaint> unknown_solver(const std::string& solver, const std::vector<std::string>& known,
                                                  const std::string& where, const std::string& user) {
  if (std::find(known.begin(), known.end(), solver) != known.end()) return {};
  const auto nearest = exchange::nearest_spelling(solver, known);
  return exchange::Complaint{
      .where = where,
      .what = user + " names an unknown solver",
      .given = solver,
      .allowed = fmt::format("{}", fmt::join(known, ", ")),
      .remedy =
          nearest ? fmt::format("did you mean {}?", *nearest)
                  : fmt::format("join it by [solver.{}] in the campaign or in ~/.config/settle/solvers.toml", solver)};
}

std::vector<std::string> words_of(const JoinedSolver& solver, const fs::path& case_file, const fs::path& result_file) {
  std::vector<std::string> words = split_command(solver.command, "command");
  for (std::string& word : words)
    word = with(with(std::move(word), "{case}", case_file.string()), "{result}", result_file.string());
  return words;
}

fs::path program_of(const JoinedSolver& solver) {
  const std::vector<std::string> words = split_command(solver.command, "command");
  if (words.empty()) return {};
  if (words.front().find('/') == std::string::npos) return find_program(words.front());
  std::error_code failure;
  return fs::is_regular_file(words.front(), failure) ? fs::absolute(words.front()) : fs::path();
}

std::string key_of(const JoinedSolver& solver) {
  std::string key = fmt::format("{}\n{}", solver.command, exchange::sha256(read_text(program_of(solver))));
  const std::vector<std::string> words = split_command(solver.command, "command");
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::error_code failure;
    if (fs::is_regular_file(words[i], failure)) key.append("\n").append(exchange::sha256(read_text(words[i])));
  }
  return key;
}

} // namespace settle::compare
