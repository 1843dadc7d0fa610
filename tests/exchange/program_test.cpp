#include "settle/exchange/program.hpp"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace settle::exchange;
using testing::HasSubstr;
using testing::MatchesRegex;

namespace {

struct Ending {
  int code;
  std::string printed;
};

Ending run(const std::function<ExitCode()>& body, LogFormat format = LogFormat::text) {
  testing::internal::CaptureStderr();
  const int code = run_program("settle-test", body, format);
  return {code, testing::internal::GetCapturedStderr()};
}

} // namespace

TEST(Sha256, AgreesWithThePublishedVectors) { // FIPS 180-2, appendix B
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Complaint, IsPrintedInTheOrderAReaderNeedsIt) {
  EXPECT_EQ(to_text({.where = "a.toml:1:2", .what = "x is wrong", .given = "1", .allowed = "2", .remedy = "add 1"}),
            "a.toml:1:2: x is wrong\n  given:   1\n  allowed: 2\n  remedy:  add 1");
  EXPECT_EQ(to_text({.where = {}, .what = "x is wrong", .given = {}, .allowed = {}, .remedy = "add 1"}),
            "x is wrong\n  remedy:  add 1");
}

TEST(RunProgram, PassesOnTheCodeOfItsBody) {
  const Ending ending = run([] { return ExitCode::verdict_failed; });
  EXPECT_EQ(ending.code, 1);
  EXPECT_EQ(ending.printed, "");
}

TEST(RunProgram, TurnsEachErrorIntoItsExitCodeAndPrintsItsText) {
  const Complaint complaint{.where = "here", .what = "it failed", .given = {}, .allowed = {}, .remedy = {}};
  EXPECT_EQ(run([&]() -> ExitCode { throw InputError(complaint); }).code, 2);
  EXPECT_EQ(run([&]() -> ExitCode { throw NotConverged(complaint); }).code, 3);
  EXPECT_EQ(run([&]() -> ExitCode { throw FileError(complaint); }).code, 4);
  EXPECT_EQ(run([&]() -> ExitCode { throw FileError(complaint); }).printed, "settle-test: here: it failed\n");
}

TEST(RunProgram, CallsAnyOtherExceptionADefectOfItsOwn) {
  const Ending ending = run([]() -> ExitCode { throw std::logic_error("index 7 of 5"); });
  EXPECT_EQ(ending.code, 70);
  EXPECT_THAT(ending.printed, HasSubstr("a defect of the program itself"));
  EXPECT_THAT(ending.printed, HasSubstr("index 7 of 5"));
  EXPECT_EQ(run([]() -> ExitCode { throw 5; }).code, 70);
}

TEST(RunProgram, WritesAnErrorAsOneLineOfJsonWhereProgramsRead) {
  const Complaint complaint{.where = "here", .what = "it \"failed\"", .given = "1\n2", .allowed = {}, .remedy = {}};
  const Ending ending = run([&]() -> ExitCode { throw InputError(complaint); }, LogFormat::json);
  EXPECT_EQ(ending.code, 2);
  EXPECT_EQ(ending.printed.find('\n'), ending.printed.size() - 1);
  const auto event = nlohmann::json::parse(ending.printed);
  EXPECT_EQ(event,
            (nlohmann::json{
                {"event", "error"}, {"program", "settle-test"}, {"exit_code", 2}, {"message", to_text(complaint)}}));
  EXPECT_THAT(run([]() -> ExitCode { throw 5; }, LogFormat::json).printed, HasSubstr("\"exit_code\":70"));
}

TEST(Provenance, HasAVersionACommitAndATime) {
  EXPECT_THAT(program_version(), MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(program_commit(), MatchesRegex("unknown|[0-9a-f]+(-dirty)?"));
  EXPECT_THAT(utc_now(), MatchesRegex("20[0-9][0-9]-[01][0-9]-[0-3][0-9]T[0-2][0-9]:[0-5][0-9]:[0-6][0-9]Z"));
}
