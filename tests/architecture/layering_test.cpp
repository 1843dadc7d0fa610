// One direction only: exchange <- mpm, exchange <- fem, exchange <- compare. Agreement of two solvers is evidence only
// as long as they share no code but the data they exchange.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

namespace {

namespace fs = std::filesystem;

const std::map<std::string, std::set<std::string>> allowed_parts{{"exchange", {"exchange"}},
                                                                 {"mpm", {"mpm", "exchange"}},
                                                                 {"fem", {"fem", "exchange"}},
                                                                 {"compare", {"compare", "exchange"}}};

std::string read(const fs::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Parts of the project that a text includes, with the line for the message.
std::map<std::string, std::string> included_parts(const std::string& text) {
  static const std::regex include(R"(#include\s*[<"](?:\.\./)*(?:settle/)?(exchange|mpm|fem|compare)/[^>"]*[>"])");
  std::map<std::string, std::string> parts;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), include); match != std::sregex_iterator(); ++match)
    parts[(*match)[1]] = match->str();
  return parts;
}

/// The part of the project that a CMake target or alias belongs to; empty for a library from outside.
std::string part_of(const std::string& target) {
  static const std::regex name(R"((?:settle::|settle_|settle-)?(exchange|results|results_mpi|mpm|fem|compare)$)");
  std::smatch match;
  if (target == "settle") return "compare";
  if (!std::regex_match(target, match, name)) return {};
  return match[1].str().starts_with("results") ? "exchange" : match[1].str();
}

std::map<std::string, std::set<std::string>> links() {
  std::map<std::string, std::set<std::string>> result;
  std::istringstream lines(read(SETTLE_LINKS_FILE));
  for (std::string line; std::getline(lines, line);) {
    const auto space = line.find(' ');
    std::istringstream libraries(line.substr(space + 1));
    auto& of_target = result[line.substr(0, space)];
    for (std::string library; std::getline(libraries, library, ';');)
      of_target.insert(library);
  }
  return result;
}

TEST(Layering, EveryPartIncludesOnlyItselfAndExchange) {
  for (const auto& [part, allowed] : allowed_parts) {
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SETTLE_SOURCE_DIR) / part)) {
      const auto extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".cpp") continue;
      ++files;
      for (const auto& [included, line] : included_parts(read(entry.path())))
        EXPECT_TRUE(allowed.contains(included)) << entry.path() << " has " << line;
    }
    EXPECT_GT(files, 5) << "no sources of " << part << " were found";
  }
}

TEST(Layering, EveryTargetLinksOnlyItsOwnPartAndExchange) {
  const auto all = links();
  ASSERT_TRUE(all.contains("settle_mpm"));
  for (const auto& [target, libraries] : all)
    for (const auto& library : libraries) {
      const std::string part = part_of(library);
      EXPECT_TRUE(part.empty() || allowed_parts.at(part_of(target)).contains(part)) << target << " links " << library;
    }
}

TEST(Layering, TheTwoBuildsOfHdf5NeverMeet) {
  for (const auto& [target, libraries] : links())
    EXPECT_FALSE(libraries.contains("settle::results") && libraries.contains("settle::results_mpi")) << target;
}

TEST(Layering, TheSolversShareNoLinearAlgebra) {
  for (const auto& [target, libraries] : links()) {
    EXPECT_FALSE(part_of(target) == "mpm" && libraries.contains("settle::dealii")) << target;
    EXPECT_FALSE(part_of(target) == "fem" && libraries.contains("Eigen3::Eigen")) << target;
  }
}

TEST(Layering, AForbiddenIncludeWouldBeSeen) {
  EXPECT_THAT(included_parts("#include \"settle/fem/solver.hpp\"\n#include <vector>\n"),
              testing::ElementsAre(testing::Pair("fem", testing::_)));
  EXPECT_EQ(part_of("settle::results_mpi"), "exchange");
  EXPECT_EQ(part_of("settle-fem"), "fem");
  EXPECT_EQ(part_of("Eigen3::Eigen"), "");
}

} // namespace
