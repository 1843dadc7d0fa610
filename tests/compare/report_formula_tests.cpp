/// \file
/// Formulas as MathML: the structure of what cases write, and what is exact of each case.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pugixml.hpp>

#include "exact_formulas.hpp"
#include "html_parts.hpp"
#include "mathml.hpp"
#include "perfect_body.hpp"
#include "report_fixture.hpp"
#include "settle/exchange/case_io.hpp"

namespace settle::compare::test {
namespace {

using report::mathml_of;
using testing::HasSubstr;
using testing::Not;

/// Without the element around it and its alternative text.
std::string inner(const std::string& formula) {
  const std::string whole = mathml_of(formula).value_or("not understood");
  const std::size_t from = whole.find('>') + 1;
  return whole.substr(from, whole.rfind('<') - from);
}

TEST(MathMl, MakesFractionsPowersAndRoots) {
  EXPECT_EQ(inner("a / (b + c)"), "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi><mo>+</mo><mi>c</mi></mrow></mfrac>");
  EXPECT_EQ(inner("x^2"), "<msup><mrow><mi>x</mi></mrow><mrow><mn>2</mn></mrow></msup>");
  EXPECT_EQ(inner("sqrt(x)"), "<msqrt><mi>x</mi></msqrt>");
  EXPECT_EQ(inner("abs(x)"), "<mrow><mo>|</mo><mi>x</mi><mo>|</mo></mrow>");
}

TEST(MathMl, KnowsGreekLettersAndIndices) {
  EXPECT_EQ(inner("lambda"), "<mi>λ</mi>");
  EXPECT_EQ(inner("sigma_xx"), "<msub><mi>σ</mi><mrow><mi>xx</mi></mrow></msub>");
  EXPECT_EQ(inner("z_{k-1}"), "<msub><mi>z</mi><mrow><mi>k</mi><mo>−</mo><mn>1</mn></mrow></msub>");
}

TEST(MathMl, KeepsParenthesesWhereTheyMatterAlone) {
  EXPECT_THAT(inner("a - (b - c)"), HasSubstr("<mo>(</mo>"));
  EXPECT_THAT(inner("(a - b) - c"), Not(HasSubstr("<mo>(</mo>")));
  EXPECT_THAT(inner("a * (b + c)"), HasSubstr("<mo>(</mo>"));
  EXPECT_THAT(inner("(a + b)^2"), HasSubstr("<mo>(</mo>"));
  EXPECT_THAT(inner("(a * b) / c"), Not(HasSubstr("<mo>(</mo>")));
  EXPECT_THAT(inner("-(a + b)"), HasSubstr("<mo>(</mo>"));
}

TEST(MathMl, ReadsSignsPowersAndProductsInTheOrderOfMuParser) {
  EXPECT_EQ(inner("-x^2"), "<mo>−</mo><msup><mrow><mi>x</mi></mrow><mrow><mn>2</mn></mrow></msup>");
  EXPECT_EQ(inner("2^-1"), "<msup><mrow><mn>2</mn></mrow><mrow><mo>−</mo><mn>1</mn></mrow></msup>");
  EXPECT_EQ(inner("a / b * c"),
            "<mfrac><mrow><mi>a</mi></mrow><mrow><mi>b</mi></mrow></mfrac><mo>\u2062</mo><mi>c</mi>");
  EXPECT_EQ(inner("2 * x"), "<mn>2</mn><mo>\u2062</mo><mi>x</mi>");
  EXPECT_THAT(inner("speed * omega"), HasSubstr("<mo>⋅</mo>"));
}

TEST(MathMl, MakesACaseDistinctionOfAChoice) {
  const std::string typeset = inner("r = abs(R - 1) < 0.25 ? R - 1 : 0.25");
  EXPECT_THAT(typeset, testing::StartsWith("<mi>r</mi><mo>=</mo><mrow><mo>{</mo><mtable>"));
  EXPECT_THAT(typeset, HasSubstr("<mtext>if\u00a0</mtext>"));
  EXPECT_THAT(typeset, HasSubstr("&lt;"));
  EXPECT_THAT(typeset, HasSubstr("<mtext>otherwise</mtext>"));
}

TEST(MathMl, GivesNothingWhereItDoesNotUnderstand) {
  for (const char* text : {"", "a +", "(a", "a b", "f(", "1e", "a_", "a ? b", "\"x\"", "a = = b", "§"})
    EXPECT_FALSE(mathml_of(text).has_value()) << text;
}

TEST(MathMl, CarriesTheFormulaAsAlternativeText) {
  EXPECT_THAT(*mathml_of("a < b"), HasSubstr("alttext=\"a &lt; b\""));
}

/// All formulas are understood, and well-formed once they are typeset.
void expect_typeset(const RunOutcome& run) {
  const std::vector<report::FormulaGroup> groups = report::exact_formulas(run);
  EXPECT_FALSE(groups.empty());
  for (const report::FormulaGroup& group : groups) {
    for (const report::Formula& formula : group.formulas) {
      const auto typeset = mathml_of(formula.text);
      ASSERT_TRUE(typeset.has_value()) << formula.text;
      pugi::xml_document document;
      EXPECT_TRUE(document.load_string(typeset->c_str())) << *typeset;
    }
  }
}

TEST(ExactFormulas, AreTypesetForEveryLawConventionAndKinematics) {
  using exchange::Convention;
  for (const exchange::Law law : {exchange::Law::rate, exchange::Law::hencky, exchange::Law::neo_hookean}) {
    for (const Convention convention :
         {Convention::refill, Convention::level_up, Convention::floating, Convention::drop}) {
      RunOutcome run = finished_run("run", {});
      run.study.materials["fill"].law = law;
      run.study.construction.convention = convention;
      expect_typeset(run);
      EXPECT_THAT(report::exact_formulas(run)[1].title, HasSubstr("what MPM solves"));
      EXPECT_THAT(report::exact_formulas(run)[2].title, HasSubstr("Small strain: what FEM solves"));
    }
  }
}

TEST(ExactFormulas, AreTypesetForEveryMotionThatShips) {
  int motions = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SETTLE_SOURCE_DIR "/cases")) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() != ".toml" || name.starts_with("campaign")) continue;
    RunOutcome run;
    try {
      run.study = exchange::read_case(entry.path());
    } catch (const exchange::InputError&) {
      continue; // no case: a campaign by another name
    }
    if (!run.study.motion) continue;
    expect_typeset(run);
    ++motions;
  }
  EXPECT_GE(motions, 6);
}

TEST(ExactFormulas, AreShownOnceAndLinkedFromTheOtherRuns) {
  CampaignOutcome outcome = synthetic_campaign({.runs = 2});
  EXPECT_THAT(report::formulas_html(outcome, outcome.runs[0]), HasSubstr("<math"));
  const std::string second = report::formulas_html(outcome, outcome.runs[1]);
  EXPECT_THAT(second, Not(HasSubstr("<math")));
  EXPECT_THAT(second, HasSubstr("href=\"#run-1-run-1-exact\""));
  outcome.runs[1].study.construction.convention = exchange::Convention::drop;
  EXPECT_THAT(report::formulas_html(outcome, outcome.runs[1]), HasSubstr("<math"));
}

TEST(ExactFormulas, FallBackToTheTextAsTheCaseHasIt) {
  CampaignOutcome outcome;
  outcome.runs.push_back(perfect_body_run(body_case()));
  outcome.runs[0].study.motion->displacement = {"X << Y", "0"};
  EXPECT_THAT(report::formulas_html(outcome, outcome.runs[0]), HasSubstr("<code>u_x = X &lt;&lt; Y</code>"));
}

} // namespace
} // namespace settle::compare::test
