#include <atomic>
#include <filesystem>

#include <fmt/format.h>

#include "gnuplot.hpp"
#include "settle/compare/process.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"
#include "temporary_folder.hpp"

namespace settle::compare::report {

namespace {

namespace fs = std::filesystem;
using exchange::FileError;

fs::path gnuplot_program() {
  const fs::path program = find_in_path("gnuplot");
  if (!program.empty()) return program;
  throw FileError({.where = "gnuplot",
                   .what = "the program that draws the report's figures is not installed",
                   .given = "not found in PATH",
                   .allowed = "",
                   .remedy = "install it (Debian: apt-get install gnuplot-nox) and write the report again"});
}

FileError failure(const ProcessOutcome& ended, const fs::path& log) {
  return FileError({.where = "gnuplot",
                    .what = fmt::format("drawing the figures failed with code {}{}", ended.code, ended.problem),
                    .given = tail_of(log, 10),
                    .allowed = "",
                    .remedy = "check the installation with `gnuplot --version` (5.4 or later is needed)"});
}

} // namespace

std::vector<std::string> run_gnuplot(const std::vector<std::string>& scripts) {
  constexpr double time_limit = 60.0; // of a figure, which takes about 0.01 s
  const fs::path program = gnuplot_program();
  const TemporaryFolder folder;
  const auto picture = [&](std::size_t i) { return folder.file(fmt::format("{}.svg", i)); };
  std::string script;
  for (std::size_t i = 0; i < scripts.size(); ++i)
    script += fmt::format("reset\nset output '{}'\n{}set output\n", picture(i).string(), scripts[i]);
  write_text(folder.file("figures.gp"), script);
  const ProcessRequest request{.program = program,
                               .arguments = {"-d", folder.file("figures.gp").string()},
                               .log = folder.file("messages"),
                               .time_limit = time_limit * static_cast<double>(scripts.size())};
  const ProcessOutcome ended = run_process(request, std::atomic<bool>{false});
  if (ended.end != ProcessEnd::exited || ended.code != 0) throw failure(ended, request.log);
  std::vector<std::string> pictures;
  for (std::size_t i = 0; i < scripts.size(); ++i)
    pictures.push_back(read_text(picture(i)));
  return pictures;
}

} // namespace settle::compare::report
