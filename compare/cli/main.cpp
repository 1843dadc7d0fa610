#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "command.hpp"
#include "settle/compare/command_words.hpp"
#include "settle/exchange/program.hpp"

namespace {

namespace exchange = settle::exchange;
namespace cli = settle::compare::cli;

std::vector<std::unique_ptr<cli::Command>> all_commands() {
  std::vector<std::unique_ptr<cli::Command>> commands;
  commands.push_back(cli::make_run_command());
  commands.push_back(cli::make_campaign_command());
  commands.push_back(cli::make_converge_command());
  commands.push_back(cli::make_compare_command());
  commands.push_back(cli::make_check_command());
  commands.push_back(cli::make_report_command());
  commands.push_back(cli::make_baseline_command());
  commands.push_back(cli::make_import_command());
  commands.push_back(cli::make_list_command());
  commands.push_back(cli::make_show_command());
  commands.push_back(cli::make_schema_command());
  commands.push_back(cli::make_doctor_command());
  return commands;
}

std::string typed(int argc, char** argv) {
  std::string text = "settle";
  for (int i = 1; i < argc; ++i)
    text += " " + settle::compare::quoted(argv[i]);
  return text;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("Coupled verification of MPM and FEM on staged construction", "settle");
  app.require_subcommand(1);
  app.set_version_flag("--version",
                       fmt::format("settle {} (commit {})", exchange::program_version(), exchange::program_commit()));
  app.footer("Exit codes: 0 all passed, 1 a verdict not passed, 2 bad input or usage, 3 a solver failed,\n"
             "4 a result or reference missing or corrupt, 130 interrupted.");
  std::string log_format = "text";
  app.add_option("--log-format", log_format, "errors as text, or as one JSON object a line")
      ->check(CLI::IsMember({"text", "json"}));
  const auto commands = all_commands();
  std::map<const CLI::App*, cli::Command*> by_app;
  for (const auto& command : commands) {
    CLI::App* subcommand = app.add_subcommand(command->name(), command->purpose());
    command->declare(*subcommand);
    by_app[subcommand] = command.get();
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& end) { // help and version end here too, with 0
    return app.exit(end) == 0 ? 0 : static_cast<int>(exchange::ExitCode::bad_input);
  }
  return exchange::run_program(
      "settle", [&] { return by_app.at(app.get_subcommands().front())->run(typed(argc, argv)); },
      log_format == "json" ? exchange::LogFormat::json : exchange::LogFormat::text);
}
