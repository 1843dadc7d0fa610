#include "settle/exchange/spelling.hpp"

#include <gtest/gtest.h>

using namespace settle::exchange;

namespace {

const std::vector<std::string> words{"height", "width", "depth", "dimension", "x", "youngs_modulus"};

} // namespace

TEST(NearestSpelling, ForgivesASwapAnInsertionADeletionAndASubstitution) {
  for (const char* slip : {"hieght", "heights", "heigt", "heighd", "HEIGHT"})
    EXPECT_EQ(nearest_spelling(slip, words), "height") << slip;
}

TEST(NearestSpelling, PrefersTheNearest) {
  EXPECT_EQ(nearest_spelling("widht", words), "width");
}

TEST(NearestSpelling, FindsALongWordWithSeveralSlips) {
  EXPECT_EQ(nearest_spelling("young_modulus", words), "youngs_modulus");
  EXPECT_EQ(nearest_spelling("youngs-modul", words), "youngs_modulus");
}

TEST(NearestSpelling, SuggestsNothingForAnotherWord) {
  for (const char* word : {"gravity", "material", "q", ""})
    EXPECT_FALSE(nearest_spelling(word, words)) << word;
  EXPECT_FALSE(nearest_spelling("height", {}));
}
