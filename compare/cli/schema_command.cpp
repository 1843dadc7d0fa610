#include <fmt/format.h>

#include "command.hpp"
#include "settle/compare/campaign_io.hpp"
#include "settle/compare/joined_solver.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::cli {
namespace {

class SchemaCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "schema"; }
  [[nodiscard]] std::string purpose() const override { return "print the JSON Schema of a file format, for editors"; }
  void declare(CLI::App& app) override {
    app.add_option("FORMAT", format_, "case, campaign or solvers; left out: case")
        ->check(CLI::IsMember({"case", "campaign", "solvers"}));
  }
  exchange::ExitCode run(const std::string&) override {
    fmt::print("{}\n", format_ == "case"       ? exchange::case_schema()
                       : format_ == "campaign" ? campaign_schema()
                                               : solvers_schema());
    return exchange::ExitCode::success;
  }

private:
  std::string format_ = "case";
};

} // namespace

std::unique_ptr<Command> make_schema_command() {
  return std::make_unique<SchemaCommand>();
}

} // namespace settle::compare::cli
