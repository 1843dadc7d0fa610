#include <fmt/format.h>

#include "command.hpp"
#include "settle/compare/import_table.hpp"
#include "settle/exchange/case_io.hpp"
#include "settle/exchange/result_io.hpp"

namespace settle::compare::cli {
namespace {

class ImportCommand : public Command {
public:
  [[nodiscard]] std::string name() const override { return "import"; }
  [[nodiscard]] std::string purpose() const override { return "make a result file of another code's table"; }
  void declare(CLI::App& app) override {
    app.require_subcommand(1);
    CLI::App* csv = app.add_subcommand("csv", "from a CSV file of material points (docs/formats.md)");
    csv->add_option("TABLE", table_, "CSV file")->required();
    csv->add_option("CASE", case_, "the case that was solved (TOML)")->required();
    csv->add_option("--out", out_, "result file to write (HDF5)")->required();
    csv->add_option("--solver", solver_, "the code that made the table; left out: import");
    csv->add_option("--kinematics", kinematics_, "what it solved, small or finite; left out: finite")
        ->check(CLI::IsMember({"small", "finite"}));
  }
  exchange::ExitCode run(const std::string&) override {
    const exchange::Case study = exchange::read_case(case_);
    const auto stages = import_stages(table_, study);
    const auto solved = kinematics_ == "small" ? exchange::Kinematics::small : exchange::Kinematics::finite;
    exchange::ResultWriter writer(out_, study, "settle-" + solver_, exchange::used_values(study, solved));
    for (const exchange::Stage& stage : stages)
      writer.write(stage);
    writer.finish(0.0, 1);
    fmt::print("{}: {} stages, {} points at the last one\n", out_, stages.size(), stages.back().points.size());
    return exchange::ExitCode::success;
  }

private:
  std::string table_, case_, out_, solver_ = "import", kinematics_ = "finite";
};

} // namespace

std::unique_ptr<Command> make_import_command() {
  return std::make_unique<ImportCommand>();
}

} // namespace settle::compare::cli
