#include "settle/exchange/solver_program.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/program.hpp"
#include "settle/exchange/result_io.hpp"
#include "settle/exchange/xdmf.hpp"

namespace settle::exchange {

namespace {

struct Arguments {
  std::string study;
  std::string out;
  std::vector<std::string> overrides;
  bool check = false;
  std::string cases;
  bool quiet = false;
  std::string log_format = "text";

  [[nodiscard]] LogFormat log() const { return log_format == "json" ? LogFormat::json : LogFormat::text; }
};

void declare(CLI::App& app, Arguments& arguments, const SolverProgram& program) {
  CLI::Option* study = app.add_option("CASE", arguments.study, "case file (TOML)");
  app.add_option("--out", arguments.out, "result file to write (HDF5)");
  app.add_option("--set", arguments.overrides, "override a key of the case, as key=value; may be repeated")
      ->allow_extra_args(false);
  CLI::Option* check = app.add_flag("--check", arguments.check, "only check that the case can be run; writes nothing");
  app.add_option("--cases", arguments.cases,
                 "with --check, instead of CASE: a JSON file with a list of cases, each {\"case\": FILE, \"set\": "
                 "[\"key=value\"]}; what cannot be run is reported as one JSON object a line")
      ->needs(check)
      ->excludes(study);
  app.add_flag("--quiet", arguments.quiet, "no progress");
  app.add_option("--log-format", arguments.log_format, "progress and errors as text, or as one JSON object a line")
      ->check(CLI::IsMember({"text", "json"}));
  app.set_version_flag("--version", fmt::format("{} {} (commit {}, {})", program.name, program_version(),
                                                program_commit(), program.libraries));
  app.footer("Exit codes: 0 finished, 2 bad input or usage, 3 not converged or no equilibrium,\n"
             "4 the result cannot be written, 70 a defect of the program.");
  if (program.declare_options) program.declare_options(app);
}

double largest_settlement(const Stage& stage, int dimension) {
  const auto dim = static_cast<std::size_t>(dimension);
  double largest = 0.0;
  for (std::size_t i = 0; i < stage.points.size(); ++i)
    largest = std::max(largest, -stage.points.displacement[i * dim + dim - 1]);
  return largest;
}

void print_event(const nlohmann::ordered_json& event) {
  std::cout << event.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
}

/// SI units; what is not a number is null.
nlohmann::ordered_json progress_event(const Case& study, const Stage& stage) {
  return {{"event", "stage"},
          {"layer", stage.layer},
          {"layers", study.construction.layers},
          {"steps", stage.steps},
          {"largest_settlement", largest_settlement(stage, study.geometry.dimension)},
          {"base_reaction", stage.base_reaction},
          {"weight", stage.weight},
          {"mass", stage.mass},
          {"mass_refilled", stage.mass_refilled},
          {"in_equilibrium", stage.in_equilibrium},
          {"wall_time", stage.wall_time}};
}

void print_progress(const Case& study, const Stage& stage, LogFormat format) {
  if (format == LogFormat::json) return print_event(progress_event(study, stage));
  const std::string reaction =
      stage.weight > 0 ? fmt::format("base reaction/weight {:.9f}, ", stage.base_reaction / stage.weight) : "";
  std::cout << fmt::format("layer {:3} of {}: {:6} steps, largest settlement {:.5f} m, {}refilled {:.3f} of {:.3f} "
                           "kg{}{}",
                           stage.layer, study.construction.layers, stage.steps,
                           largest_settlement(stage, study.geometry.dimension), reaction, stage.mass_refilled,
                           stage.mass, study.geometry.dimension == 2 ? "/m" : "",
                           stage.in_equilibrium ? "" : ", NOT in equilibrium")
            << std::endl;
}

nlohmann::ordered_json failure_event(const Failure& failure) {
  nlohmann::ordered_json event{{"event", "failure"}, {"stage", failure.stage}, {"share", failure.share}};
  if (failure.run_out)
    event["run_out"] = {{"at_rest", failure.run_out->at_rest},
                        {"duration", failure.run_out->duration},
                        {"largest_displacement", failure.run_out->largest_displacement},
                        {"distance", failure.run_out->distance},
                        {"surface_height", failure.run_out->state.surface_height}};
  return event;
}

void print_failure(const Failure& failure, LogFormat format) {
  if (format == LogFormat::json) return print_event(failure_event(failure));
  std::cout << fmt::format("failed in stage {}, beyond {:.4f} of it\n", failure.stage, failure.share);
  if (!failure.run_out) return;
  const RunOut& run_out = *failure.run_out;
  std::cout << fmt::format("run-out: {} after {:.4g} s, {:.4g} m beyond where the body ended, largest displacement "
                           "{:.4g} m, surface at {:.4g} m, {:.2g} of the work of gravity unaccounted\n",
                           run_out.at_rest ? "at rest" : "NOT at rest", run_out.duration, run_out.distance,
                           run_out.largest_displacement, run_out.state.surface_height,
                           run_out.unaccounted() / run_out.external_work);
}

void solve(const SolverProgram& program, const Case& study, const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  ResultWriter writer(arguments.out, study, program.name, program.used(study));
  XdmfIndex index(arguments.out, study.geometry.dimension);
  const std::optional<Failure> failure = program.solve(study, [&](const Stage& stage) {
    writer.write(stage);
    index.add(stage);
    if (!arguments.quiet) print_progress(study, stage, arguments.log());
  });
  writer.finish(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
                program.threads ? program.threads(study) : 1, failure);
  if (failure && failure->run_out) index.add(*failure->run_out);
  index.write();
  if (failure && !arguments.quiet) print_failure(*failure, arguments.log());
}

/// A case of a list, with what is set.
struct ListedCase {
  std::string file;
  std::vector<std::string> overrides;
};

std::vector<ListedCase> cases_in(const std::string& file) {
  std::ifstream input(file);
  try {
    std::vector<ListedCase> cases;
    for (const nlohmann::json& entry : nlohmann::json::parse(input))
      cases.push_back({entry.at("case").get<std::string>(),
                       entry.value("set", nlohmann::json::array()).get<std::vector<std::string>>()});
    return cases;
  } catch (const nlohmann::json::exception& error) {
    throw InputError({.where = file,
                      .what = "the list of cases cannot be read",
                      .given = error.what(),
                      .allowed = "a JSON array of {\"case\": FILE, \"set\": [\"key=value\"]}",
                      .remedy = "correct the file"});
  }
}

/// Checks all cases of a list: starting a program may take longer than reading many of them.
ExitCode check_all(const SolverProgram& program, const std::vector<ListedCase>& cases) {
  ExitCode code = ExitCode::success;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    try {
      program.check(read_case(cases[i].file, cases[i].overrides));
    } catch (const InputError& error) {
      code = ExitCode::bad_input;
      print_event({{"event", "refused"}, {"case", i}, {"message", fmt::format("{}: {}", program.name, error.what())}});
    }
  }
  return code;
}

ExitCode run(const SolverProgram& program, const Arguments& arguments) {
  if (!arguments.cases.empty()) return check_all(program, cases_in(arguments.cases));
  if (arguments.study.empty())
    throw InputError({.where = "CASE",
                      .what = "the case file is not given",
                      .given = "",
                      .allowed = "a TOML file",
                      .remedy = fmt::format("{} CASE --out RESULT.h5", program.name)});
  if (!arguments.check && arguments.out.empty())
    throw InputError({.where = "--out",
                      .what = "the result file is not given",
                      .given = "",
                      .allowed = "--out RESULT.h5",
                      .remedy = "name a file, or use --check to run nothing"});
  const Case study = read_case(arguments.study, arguments.overrides);
  const std::string summary = program.check(study);
  if (!arguments.check)
    solve(program, study, arguments);
  else if (arguments.log() == LogFormat::json)
    print_event({{"event", "checked"}, {"case", study.file}, {"program", program.name}, {"what", summary}});
  else
    std::cout << fmt::format("{}: {} can run this case: {}\n", study.file, program.name, summary);
  return ExitCode::success;
}

} // namespace

int run_solver(const SolverProgram& program, int argc, char** argv) {
  CLI::App app(program.description, program.name);
  Arguments arguments;
  declare(app, arguments, program);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& end) {
    return app.exit(end) == 0 ? 0 : static_cast<int>(ExitCode::bad_input); // help and version end here too, with 0
  }
  return run_program(
      program.name, [&] { return run(program, arguments); }, arguments.log());
}

} // namespace settle::exchange
