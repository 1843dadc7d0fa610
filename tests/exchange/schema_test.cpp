#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "full_case.hpp"
#include "settle/exchange/case_io.hpp"

using namespace settle::exchange;
using nlohmann::json;

namespace {

/// The schema of a dotted key: names of tables that the user chooses and items of arrays lead to their common schema.
const json* schema_of(const json& schema, const std::string& key) {
  const json* inside = &schema;
  std::stringstream parts(key);
  for (std::string part; std::getline(parts, part, '.');) {
    if (inside->contains("items")) {
      inside = &inside->at("items");
    } else if (inside->contains("properties")) {
      if (!inside->at("properties").contains(part)) return nullptr;
      inside = &inside->at("properties").at(part);
    } else {
      inside = &inside->at("additionalProperties");
    }
  }
  return inside;
}

std::string text_of(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

} // namespace

TEST(CaseSchema, ListsEveryKeyThatCanBeRead) {
  const json schema = json::parse(case_schema());
  const Case study = parse_case(full_case, "full.toml");
  ASSERT_GT(study.origins.size(), 60U);
  for (const auto& [key, where] : study.origins)
    EXPECT_NE(schema_of(schema, key), nullptr) << key;
}

TEST(CaseSchema, StatesTypesRangesDefaultsAndRequiredKeys) {
  const json schema = json::parse(case_schema());
  EXPECT_EQ(schema["$schema"], "http://json-schema.org/draft-07/schema#");
  EXPECT_EQ(schema["required"], json::parse(R"(["format","gravity","geometry","material","construction"])"));
  const json& ratio = *schema_of(schema, "material.any.poissons_ratio");
  EXPECT_EQ(ratio["type"], "number");
  EXPECT_EQ(ratio["exclusiveMinimum"], -1.0);
  EXPECT_EQ(ratio["exclusiveMaximum"], 0.5);
  const json& convention = *schema_of(schema, "construction.convention");
  EXPECT_EQ(convention["enum"], json::parse(R"(["refill","level-up","float","drop"])"));
  EXPECT_EQ(schema_of(schema, "mpm.element_size")->at("default"), 0.125);
  EXPECT_EQ(schema_of(schema, "check.0.over")->at("enum"), json::parse(R"(["points","probes","fields"])"));
  EXPECT_EQ(schema_of(schema, "check.0.between")->at("minItems"), 2);
  EXPECT_EQ(schema_of(schema, "geometry")->at("additionalProperties"), false);
}

TEST(FormatsDocument, HoldsTheKeysAsTheProgramKnowsThem) {
  const std::string document = text_of(SETTLE_SOURCE_DIR "/docs/formats.md");
  const std::string begin = "<!-- keys of the case file: begin -->\n", end = "<!-- keys of the case file: end -->";
  const std::size_t first = document.find(begin), last = document.find(end);
  ASSERT_NE(first, std::string::npos);
  ASSERT_NE(last, std::string::npos);
  const std::string keys = document.substr(first + begin.size(), last - first - begin.size());
  EXPECT_EQ(keys, case_keys_markdown()) << "copy the text the program gives into docs/formats.md";
}
