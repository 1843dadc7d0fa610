/// \file
/// What drawings of a page have in common stands in it once, and nothing of what is seen is lost.
#include <regex>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shared_shapes.hpp"
#include "svg_path.hpp"

namespace settle::compare::test {
namespace {

using namespace report;
using testing::HasSubstr;
using testing::Not;

const std::string axis = R"(<path class="axis" d="M80 442H522M106.1 442V446M239.3 442V446M372.4 442V446"/>)";
const std::string words = R"(<g class=middle><text x=106.1 y=460>0</text><text x=239.3 y=460>settlement</text></g>)";

std::string curve(int number) {
  return fmt::format(R"(<path class=line stroke="#0072B2" d="M{} 440.2l-1.2-17.5-3.6-21.1-7.6-8.8-6.8-21.1"/>)",
                     number);
}

std::string drawing(const std::string& content) {
  return R"(<svg viewBox="0 0 540 494" role="img" aria-label="a">)" + content + "</svg>";
}

std::string page_of(const std::vector<std::string>& drawings) {
  std::string page = "<html><head></head><body class=\"a\"><p>words</p>";
  for (const std::string& each : drawings)
    page += "<figure>" + each + "</figure>";
  return page + "</body></html>";
}

/// The page as it was: definitions put back where they are referred to.
std::string expanded(std::string page) {
  const std::size_t begin = page.find("<svg class=\"shared\""), end = page.find("</defs></svg>");
  const std::string definitions = page.substr(begin, end - begin);
  page.erase(begin, end + 13 - begin);
  for (const auto& [opening, closing] :
       {std::pair{"<path id=\"", "/>"}, std::pair{"<g id=\"", "</g>"}, std::pair{"<text id=\"", "</text>"}}) {
    for (std::size_t at = definitions.find(opening); at != std::string::npos; at = definitions.find(opening, at + 1)) {
      const std::size_t name = at + std::string(opening).size(), quote = definitions.find('"', name);
      const std::size_t behind = definitions.find(closing, name) + std::string(closing).size();
      const std::string reference = fmt::format("<use href=\"#{}\"/>", definitions.substr(name, quote - name));
      const std::string shape =
          definitions.substr(at, name - at - 5) + definitions.substr(quote + 1, behind - quote - 1);
      for (std::size_t place; (place = page.find(reference)) != std::string::npos;)
        page.replace(place, reference.size(), shape);
    }
  }
  return page;
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(SharedShapes, WhatThreeDrawingsHaveAlikeStandsInThePageOnce) {
  const std::string page = page_of({drawing(axis + curve(1)), drawing(axis + curve(2)), drawing(axis + curve(3))});
  const std::string shared = with_shared_shapes(page);
  EXPECT_EQ(occurrences(shared, "M80 442H522"), 1U);
  EXPECT_EQ(occurrences(shared, "<use href=\"#s0\"/>"), 3U);
  EXPECT_THAT(shared,
              HasSubstr("<body class=\"a\"><svg class=\"shared\" width=\"0\" height=\"0\" aria-hidden=\"true\">"));
  for (int i = 1; i <= 3; ++i)
    EXPECT_THAT(shared, HasSubstr(curve(i)));
  EXPECT_EQ(expanded(shared), page);
}

TEST(SharedShapes, NothingOfAPageIsLost) {
  std::vector<std::string> drawings;
  for (int i = 0; i < 12; ++i)
    drawings.push_back(drawing((i % 2 == 0 ? axis : "") + words + curve(i % 3) + (i % 5 == 0 ? words : axis)));
  const std::string page = page_of(drawings);
  const std::string shared = with_shared_shapes(page);
  EXPECT_LT(shared.size(), page.size() * 3 / 4); // axes and words are most of each drawing
  EXPECT_EQ(expanded(shared), page);
}

TEST(SharedShapes, WhatIsRareOrShortStaysWhereItIs) {
  const std::string two = page_of({drawing(axis + curve(1)), drawing(axis + curve(2))});
  EXPECT_EQ(with_shared_shapes(two), two);
  const std::string small = drawing("<path d=\"M0 0h1\"/>");
  const std::string tiny = page_of({small, small, small, small});
  EXPECT_EQ(with_shared_shapes(tiny), tiny);
}

TEST(SharedShapes, ADrawingThatHoldsSomethingElseStaysAsItIs) {
  const std::string other = drawing(axis + "<image href=\"data:\"/>" + words);
  const std::string page = page_of({other, other, other, drawing(axis), drawing(axis), drawing(axis)});
  const std::string shared = with_shared_shapes(page);
  EXPECT_EQ(occurrences(shared, other), 3U);
  EXPECT_EQ(occurrences(shared, "<use href"), 3U);
}

TEST(SharedShapes, APageWithoutDrawingsIsLeftAlone) {
  EXPECT_EQ(with_shared_shapes(page_of({})), page_of({}));
  EXPECT_EQ(with_shared_shapes(""), "");
}

/// Points of a path that is made of M, m, h, v, l and z, as a browser moves its pen.
std::vector<SvgPoint> drawn(const std::string& path) {
  std::vector<SvgPoint> points;
  SvgPoint pen, start;
  const std::regex command("([MmhvlzZ])|(-?[0-9]*\\.?[0-9]+)");
  char letter = ' ';
  std::vector<double> numbers;
  for (std::sregex_iterator at(path.begin(), path.end(), command), last; at != last; ++at) {
    if ((*at)[1].matched) {
      letter = (*at)[1].str().front();
      if (letter == 'z') pen = start;
      continue;
    }
    numbers.push_back(std::stod((*at)[2].str()));
    const bool is_one = letter == 'h' || letter == 'v';
    if (numbers.size() < (is_one ? 1U : 2U)) continue;
    if (letter == 'M') pen = {numbers[0], numbers[1]};
    if (letter == 'm' || letter == 'l') pen = {pen.x + numbers[0], pen.y + numbers[1]};
    if (letter == 'h') pen.x += numbers[0];
    if (letter == 'v') pen.y += numbers[0];
    if (letter == 'm' || letter == 'M') start = pen;
    points.push_back(pen);
    numbers.clear();
  }
  return points;
}

TEST(SvgPath, StartsLinesRelativeToTheEndOfTheLastWhereThatIsShorter) {
  const std::vector<SvgLine> lines{{.points = {{484.2, 440.2}}},
                                   {.points = {{488.4, 438.5}}},
                                   {.points = {{490, 438}, {491, 437}, {492, 440}}, .closed = true},
                                   {.points = {{490.5, 438.5}, {20, 30}}},
                                   {.points = {{1, 2}}}};
  const std::string text = path_text(lines);
  EXPECT_EQ(text, "M484.2 440.2h0m4.2-1.7h0m1.6-.5l1-1 1 3zm.5 .5l-470.5-408.5M1 2h0");
  const std::vector<SvgPoint> points = drawn(text);
  const std::vector<SvgPoint> expected{{484.2, 440.2}, {484.2, 440.2}, {488.4, 438.5}, {488.4, 438.5},
                                       {490, 438},     {491, 437},     {492, 440},     {490.5, 438.5},
                                       {20, 30},       {1, 2},         {1, 2}};
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].x, expected[i].x, 1e-9) << i;
    EXPECT_NEAR(points[i].y, expected[i].y, 1e-9) << i;
  }
}

} // namespace
} // namespace settle::compare::test
