#include "settle/exchange/document.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "settle/exchange/errors.hpp"

using namespace settle::exchange;
using document::Table;

namespace {

const char* const text = R"(name = "tab\tquote\" backslash\\ µ"
count = -3
ratio = 0.1
large = 1e300
flags = [true, false]
empty = []
nested = [[1, 2], [3.5]]
inside = [{a = 1}]

[table]
"a key" = 1

[table.deeper]
b = 2

[[row]]
c = 3

[[row]]
c = 4

[[row.cell]]
d = 5
)";

} // namespace

TEST(Document, IsWrittenSoThatItReadsTheSame) {
  const std::string once = document::to_toml(document::parse(text, "a"));
  EXPECT_EQ(document::to_toml(document::parse(once, "b")), once);
  const Table table = document::parse(once, "b");
  EXPECT_EQ(std::get<std::string>(document::find(table, "name")->data), "tab\tquote\" backslash\\ µ");
  EXPECT_EQ(std::get<std::int64_t>(document::find(table, "count")->data), -3);
  EXPECT_EQ(std::get<double>(document::find(table, "large")->data), 1e300);
  EXPECT_EQ(std::get<document::List>(document::find(table, "row")->data).size(), 2U);
}

TEST(Document, KnowsWhereEveryValueStands) {
  const Table table = document::parse(text, "a.toml");
  EXPECT_EQ(document::find(table, "ratio")->where, "a.toml:3:9");
  const auto& row = std::get<document::List>(document::find(table, "row")->data)[1];
  EXPECT_EQ(document::find(std::get<Table>(row.data), "c")->where, "a.toml:20:5");
  EXPECT_EQ(document::find(table, "absent"), nullptr);
}

TEST(Document, WritesNumbersThatRoundTrip) {
  for (const double number : {0.1, 1.0, -0.0, 1e-9, 1e22, 12345678901234567.0, std::numeric_limits<double>::min()}) {
    const auto value = document::parse_value(document::to_inline_toml({number, {}}), "here");
    EXPECT_EQ(std::get<double>(value.data), number);
  }
}

TEST(Document, ValueThatIsNotOneIsRefusedAtItsPlace) {
  for (const char* wrong : {"", "1 2", "abc", "1\nb = 2"}) {
    try {
      static_cast<void>(document::parse_value(wrong, "the key x"));
      ADD_FAILURE() << wrong;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith("the key x: "));
    }
  }
}

TEST(Document, BecomesJsonInItsOwnOrder) {
  const auto json = nlohmann::ordered_json::parse(document::to_json({document::parse(text, "a"), {}}));
  EXPECT_EQ(json["flags"], nlohmann::ordered_json::parse("[true, false]"));
  EXPECT_EQ(json["row"][1]["cell"][0]["d"], 5);
  EXPECT_EQ(json["table"]["a key"], 1);
}
