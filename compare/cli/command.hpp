/// \file
/// A subcommand of `settle`.
#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "settle/exchange/errors.hpp"

namespace settle::compare::cli {

class Command {
public:
  Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  virtual ~Command() = default;

  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual std::string purpose() const = 0;
  /// Adds its arguments; they are bound to this object.
  virtual void declare(CLI::App& app) = 0;
  /// `command_line`: what was typed. Throws exchange::Error.
  virtual exchange::ExitCode run(const std::string& command_line) = 0;
};

std::unique_ptr<Command> make_run_command();
std::unique_ptr<Command> make_campaign_command();
std::unique_ptr<Command> make_converge_command();
std::unique_ptr<Command> make_compare_command();
std::unique_ptr<Command> make_check_command();
std::unique_ptr<Command> make_report_command();
std::unique_ptr<Command> make_baseline_command();
std::unique_ptr<Command> make_import_command();
std::unique_ptr<Command> make_list_command();
std::unique_ptr<Command> make_show_command();
std::unique_ptr<Command> make_schema_command();
std::unique_ptr<Command> make_doctor_command();

} // namespace settle::compare::cli
