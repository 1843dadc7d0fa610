#include <atomic>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "gnuplot.hpp"
#include "settle/compare/process.hpp"
#include "settle/compare/text_file.hpp"
#include "settle/exchange/errors.hpp"

namespace settle::compare::report {

namespace {

namespace fs = std::filesystem;
using exchange::FileError;

/// A folder of its own that is gone afterwards.
class ScratchFolder {
public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "settle-figure-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw FileError({.where = fs::temp_directory_path().string(),
                       .what = "cannot create a folder for a figure's data",
                       .given = "",
                       .allowed = "",
                       .remedy = "set TMPDIR to a folder that can be written"});
    }
    path_ = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code ignored; // nothing is lost with a temporary folder that stays
    fs::remove_all(path_, ignored);
  }
  [[nodiscard]] fs::path file(const char* name) const { return path_ / name; }

private:
  fs::path path_;
};

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
                    .what = fmt::format("drawing a figure failed with code {}{}", ended.code, ended.problem),
                    .given = tail_of(log, 10),
                    .allowed = "",
                    .remedy = "check the installation with `gnuplot --version` (5.4 or later is needed)"});
}

} // namespace

std::string run_gnuplot(const std::string& script) {
  constexpr double time_limit = 60.0; // a figure takes about 0.05 s
  const fs::path program = gnuplot_program();
  const ScratchFolder folder;
  const fs::path picture = folder.file("figure.svg");
  write_text(folder.file("figure.gp"), fmt::format("set output '{}'\n", picture.string()) + script);
  const ProcessRequest request{.program = program,
                               .arguments = {"-d", folder.file("figure.gp").string()},
                               .log = folder.file("messages"),
                               .time_limit = time_limit};
  const ProcessOutcome ended = run_process(request, std::atomic<bool>{false});
  if (ended.end != ProcessEnd::exited || ended.code != 0) throw failure(ended, request.log);
  return read_text(picture);
}

} // namespace settle::compare::report
