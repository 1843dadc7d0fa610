#include "settle/compare/command_words.hpp"

#include <gmock/gmock.h>

#include "settle/exchange/errors.hpp"

namespace settle::compare::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

std::string error_of(const std::string& command) {
  try {
    split_command(command, "file.toml:3:11");
  } catch (const exchange::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(CommandWords, ArePartedByBlanksAndKeptTogetherByQuotes) {
  EXPECT_THAT(split_command("  code  --in {case}\t{result} ", ""), ElementsAre("code", "--in", "{case}", "{result}"));
  EXPECT_THAT(split_command(R"(sh -c 'a "b" > c' "d \"e\" \f" g\ h '' i'j k'l)", ""),
              ElementsAre("sh", "-c", "a \"b\" > c", "d \"e\" \\f", "g h", "", "ij kl"));
  EXPECT_TRUE(split_command(" ", "").empty());
}

TEST(CommandWords, NothingIsExpanded) {
  EXPECT_THAT(split_command("echo $HOME *.toml ~ `date`", ""), ElementsAre("echo", "$HOME", "*.toml", "~", "`date`"));
}

TEST(CommandWords, OperatorsOfAShellAndOpenQuotesAreRefused) {
  for (const std::string operator_ : {"> log", "2>&1", ">>log", "| tee log", "&& echo", "; echo", "&", "< in"}) {
    EXPECT_THAT(error_of("code {case} " + operator_), AllOf(HasSubstr("file.toml:3:11"), HasSubstr("sh -c")))
        << operator_;
  }
  EXPECT_THAT(error_of("code 'open"), HasSubstr("quote ' is not closed"));
  EXPECT_THAT(error_of("code \"open"), HasSubstr("quote \" is not closed"));
  EXPECT_EQ(error_of("code '>' \"|\" a>b"), "no error");
}

TEST(CommandWords, WhatIsJoinedIsSplitIntoTheSame) {
  const std::vector<std::string> words{"a b", "it's", "", "\"", "\\", "{case}", "--x=1"};
  EXPECT_EQ(split_command(joined(words), ""), words);
}

} // namespace
} // namespace settle::compare::test
