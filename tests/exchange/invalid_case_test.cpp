#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "settle/exchange/case_io.hpp"
#include "settle/exchange/errors.hpp"

using namespace settle::exchange;
using testing::HasSubstr;

namespace {

const std::filesystem::path folder = std::filesystem::path(SETTLE_SOURCE_DIR) / "tests" / "invalid";

/// What a file says about itself in its leading lines `# expect: ...`.
std::vector<std::string> expectations(const std::filesystem::path& file) {
  const std::string mark = "# expect: ";
  std::vector<std::string> texts;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line) && line.starts_with(mark);)
    texts.push_back(line.substr(mark.size()));
  return texts;
}

std::vector<std::string> invalid_files() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  return names;
}

/// The message of the InputError that reading the file throws; empty if it throws none.
std::string complaint_about(const std::filesystem::path& file) {
  try {
    static_cast<void>(read_case(file));
  } catch (const InputError& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    return error.what();
  }
  return {};
}

class InvalidCase : public testing::TestWithParam<std::string> {};

} // namespace

TEST_P(InvalidCase, IsRefusedWithTheMessageItExpects) {
  const auto file = folder / (GetParam() + ".toml");
  const auto expected = expectations(file);
  ASSERT_FALSE(expected.empty()) << file << " states no message";
  const std::string message = complaint_about(file);
  for (const std::string& text : expected)
    EXPECT_THAT(message, HasSubstr(text));
}

INSTANTIATE_TEST_SUITE_P(Files, InvalidCase, testing::ValuesIn(invalid_files()),
                         [](const auto& parameter) { return parameter.param; });

TEST(InvalidCaseFile, ThatIsMissingIsNamedWithTheReason) {
  EXPECT_THAT(complaint_about("no/such/case.toml"), HasSubstr("no/such/case.toml: the file cannot be read"));
  EXPECT_THAT(complaint_about("no/such/case.toml"), HasSubstr("No such file or directory"));
}

TEST(InvalidCaseFile, ThatIsAFolderIsNamedAsOne) {
  EXPECT_THAT(complaint_about(folder), HasSubstr("given:   a folder"));
}

TEST(InvalidCaseFile, ThatIsNotTextIsNotValidToml) {
  const auto file = std::filesystem::path(testing::TempDir()) / "binary.toml";
  std::ofstream(file, std::ios::binary) << "\x89HDF\r\n\x1a\n";
  EXPECT_THAT(complaint_about(file), HasSubstr("binary.toml:1:1: not valid TOML"));
}
