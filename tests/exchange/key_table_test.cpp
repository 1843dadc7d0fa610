#include "settle/exchange/key_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace settle::exchange;
using testing::HasSubstr;

namespace {

struct Curve {
  std::string label;
  std::optional<int> width;
};

struct Figure {
  std::string name;
  std::vector<Curve> curves;
};

struct Plan {
  std::map<std::string, std::string> set;
  std::map<std::string, std::vector<std::string>> matrix;
  std::vector<std::string> solvers{"mpm", "fem"};
  std::vector<Figure> figures;
};

KeyTable<Plan> plan_keys() {
  KeyTable<Curve> curve("A curve.");
  curve.text("label", &Curve::label, {.required = true, .doc = "its label"});
  curve.integer("width", &Curve::width, {.unit = "px", .range = from_to(1, 5), .left_out = "thin", .doc = "its width"});
  KeyTable<Figure> figure("A figure.");
  figure.text("name", &Figure::name, {.required = true, .doc = "its name"});
  figure.table_array("curve", &Figure::curves, std::move(curve));
  KeyTable<Plan> plan("A plan.");
  plan.toml_values("set", &Plan::set, {.doc = "what is set"});
  plan.toml_lists("matrix", &Plan::matrix, {.doc = "what is varied"});
  plan.texts("solvers", &Plan::solvers, {.count = {.least = 1}, .doc = "who solves"});
  plan.table_array("figure", &Plan::figures, std::move(figure));
  return plan;
}

Plan read(const std::string& text) {
  Reading reading;
  Plan plan;
  plan_keys().read(document::parse(text, "plan.toml"), {.path = {}, .where = "plan.toml"}, plan, reading);
  reading.throw_if_any();
  return plan;
}

std::string complaint_about(const std::string& text) {
  try {
    static_cast<void>(read(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

const char* const plan_text = R"(
solvers = ["mpm"]
[set]
construction.layers = 5
"mpm.scheme" = "explicit"
[matrix]
"geometry.height" = [1, 2.5]
mpm.refill = ["element", "sub-element"]
[[figure]]
name = "first"
[[figure.curve]]
label = "a"
[[figure.curve]]
label = "b"
width = 2
[[figure]]
name = "second"
)";

} // namespace

TEST(KeyTable, ReadsFreeKeysAsTomlTextWhetherQuotedOrNested) {
  const Plan plan = read(plan_text);
  EXPECT_EQ(plan.set,
            (std::map<std::string, std::string>{{"construction.layers", "5"}, {"mpm.scheme", "\"explicit\""}}));
  EXPECT_EQ(plan.matrix.at("geometry.height"), (std::vector<std::string>{"1", "2.5"}));
  EXPECT_EQ(plan.matrix.at("mpm.refill"), (std::vector<std::string>{"\"element\"", "\"sub-element\""}));
}

TEST(KeyTable, ReadsArraysOfTablesInsideArraysOfTables) {
  const Plan plan = read(plan_text);
  ASSERT_EQ(plan.figures.size(), 2U);
  ASSERT_EQ(plan.figures[0].curves.size(), 2U);
  EXPECT_FALSE(plan.figures[0].curves[0].width.has_value());
  EXPECT_EQ(plan.figures[0].curves[1].width, 2);
  EXPECT_TRUE(plan.figures[1].curves.empty());
}

TEST(KeyTable, WritesWhatItReads) {
  const std::string once = document::to_toml(plan_keys().write(read(plan_text)));
  EXPECT_EQ(document::to_toml(plan_keys().write(read(once))), once);
  EXPECT_EQ(read(once).matrix, read(plan_text).matrix);
  EXPECT_EQ(read(once).set, read(plan_text).set);
}

TEST(KeyTable, NamesTheEntryOfAnArrayThatIsWrong) {
  EXPECT_THAT(complaint_about("[[figure]]\nname = \"a\"\n[[figure.curve]]\nlabel = \"b\"\nwidth = 9\n"),
              HasSubstr("plan.toml:5:9: figure.0.curve.0.width is not an allowed value"));
  EXPECT_THAT(complaint_about("[[figure]]\nname = \"a\"\n[[figure.curve]]\nlable = \"b\"\n"),
              HasSubstr("plan.toml:4:1: figure.0.curve.0.lable is not a known key"));
  EXPECT_THAT(complaint_about("solvers = [\"mpm\", 3]\n"), HasSubstr("plan.toml:1:19: solvers.1 has the wrong type"));
  EXPECT_THAT(complaint_about("solvers = []\n"), HasSubstr("solvers is not an allowed value"));
}

TEST(KeyTable, WantsAListForAKeyThatIsVaried) {
  EXPECT_THAT(complaint_about("[matrix]\nmpm.refill = \"element\"\n"),
              HasSubstr("plan.toml:2:14: matrix.mpm.refill has the wrong type"));
  EXPECT_THAT(complaint_about("[matrix]\nmpm.refill = []\n"), HasSubstr("an array of at least one value"));
  EXPECT_THAT(complaint_about("set = 3\n"), HasSubstr("a table of dotted keys with their values"));
}

TEST(KeyTable, DoesNotCallAKeyMissingThatIsMisspelt) {
  const std::string message = complaint_about("[[figure]]\nnmae = \"a\"\n");
  EXPECT_THAT(message, HasSubstr("did you mean name?"));
  EXPECT_THAT(message, testing::Not(HasSubstr("is missing")));
}

TEST(KeyTable, DocumentsItselfAndTheTablesInside) {
  std::vector<TableDoc> docs;
  plan_keys().describe("", "", docs);
  const std::string text = to_markdown(docs);
  EXPECT_THAT(text, HasSubstr("#### `[[figure.curve]]`\n\nA curve.\n"));
  EXPECT_THAT(text, HasSubstr("| `width` | an integer from 1 to 5 [px] | thin | its width |"));
  EXPECT_THAT(text, HasSubstr("| `label` | a text that is not empty | required | its label |"));
  EXPECT_THAT(
      text, HasSubstr("| `solvers` | an array of at least 1, each a text that is not empty | `[\"mpm\", \"fem\"]` |"));
}

TEST(Range, HoldsItsEndsUnlessTheyAreOpen) {
  EXPECT_FALSE(above(0).contains(0));
  EXPECT_TRUE(at_least(0).contains(0));
  EXPECT_TRUE(from_to(2, 3).contains(3));
  EXPECT_FALSE(from_to_below(0, 1).contains(1));
  EXPECT_TRUE(above_to(0, 1).contains(1));
  EXPECT_FALSE(between(-1, 0.5).contains(0.5));
  EXPECT_FALSE(between(-1, 0.5).contains(-1));
  EXPECT_TRUE(exactly(1).contains(1));
  EXPECT_FALSE(exactly(1).contains(2));
  EXPECT_TRUE(Range{}.contains(-1e300));
}
