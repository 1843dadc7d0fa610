/// \file
/// Colours, pixels, PNG and axes: what pictures are made of.
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "chart_frame.hpp"
#include "colour_map.hpp"
#include "raster.hpp"

namespace settle::compare::test {
namespace {

using namespace report;
using exchange::PlanePoint;

double linear(std::uint8_t part) {
  const double share = part / 255.0;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

/// Lightness and the two opponent axes of OKLab, by the matrices from sRGB (B. Ottosson, 2020).
std::array<double, 3> oklab(const Colour& colour) {
  const double r = linear(colour[0]), g = linear(colour[1]), b = linear(colour[2]);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double distance(const Colour& a, const Colour& b) {
  const auto first = oklab(a), second = oklab(b);
  return std::hypot(first[0] - second[0], first[1] - second[1], first[2] - second[2]);
}

/// What somebody without green cones sees (Machado, Oliveira & Fernandes 2009, severity 1), lightness only.
double lightness_to_deuteranopes(const Colour& colour) {
  const double r = linear(colour[0]), g = linear(colour[1]), b = linear(colour[2]);
  const double red = 0.367322 * r + 0.860646 * g - 0.227968 * b;
  const double green = 0.280085 * r + 0.672501 * g + 0.047413 * b;
  const double blue = -0.011820 * r + 0.042940 * g + 0.968881 * b;
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

TEST(ColourMap, HasEqualStepsThatLookEqual) {
  constexpr int steps = 16;
  double least = 1.0, most = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double step =
        distance(colour_at(ColourMap::even, double(i) / steps), colour_at(ColourMap::even, double(i + 1) / steps));
    least = std::min(least, step);
    most = std::max(most, step);
  }
  EXPECT_LT(most / least, 1.1); // a colour is rounded to 1/255: 0.002 of steps of 0.045 at either end
}

TEST(ColourMap, RisesInLightnessForEveryone) {
  double before = -1.0;
  for (int i = 0; i <= 32; ++i) {
    const double now = lightness_to_deuteranopes(colour_at(ColourMap::even, i / 32.0));
    EXPECT_GT(now, before) << i;
    before = now;
  }
}

TEST(ColourMap, OfASignIsEquallyFarFromWhiteOnBothSides) {
  const Colour middle = colour_at(ColourMap::two_sided, 0.5);
  for (const double size : {0.1, 0.3, 0.5}) {
    const Colour low = colour_at(ColourMap::two_sided, 0.5 - size), high = colour_at(ColourMap::two_sided, 0.5 + size);
    EXPECT_NEAR(distance(low, middle), distance(high, middle), 0.006) << size; // rounding to 1/255 of three parts
    EXPECT_NEAR(oklab(low)[0], oklab(high)[0], 0.006) << size;
  }
}

TEST(Raster, FillsThePixelsWhoseMiddlesAreWithin) {
  Raster raster({.lowest = {0.0, 0.0}, .highest = {4.0, 3.0}}, {1.0, 1.0});
  raster.fill({{{0.6, 0.4}, {2.4, 0.4}, {2.6, 1.6}, {0.4, 1.6}}}, 7);
  int filled = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      filled += raster.at(column, row) == 7 ? 1 : 0;
  EXPECT_EQ(filled, 4); // of the lower row (1.5, 0.5) alone, of the middle one those at 0.5, 1.5 and 2.5
  EXPECT_EQ(raster.at(1, 2), 7);
  EXPECT_EQ(raster.at(0, 1) + raster.at(1, 1) + raster.at(2, 1), 21);
}

TEST(Raster, LeavesNoSeamBetweenNeighbours) {
  Raster raster({.lowest = {0.0, 0.0}, .highest = {1.0, 1.0}}, {0.01, 0.01});
  raster.fill({{{0.0, 0.0}, {0.5, 0.0}, {0.3, 1.0}, {0.0, 1.0}}}, 1);
  raster.fill({{{0.3, 1.0}, {0.5, 0.0}, {1.0, 0.0}, {1.0, 1.0}}}, 2); // the other way round
  EXPECT_THAT(raster.pixels(), testing::Not(testing::Contains(Raster::background)));
}

TEST(Raster, GivesAPixelToTheNearestPointWhateverTheOrder) {
  const exchange::PlaneBox box{.lowest = {0.0, 0.0}, .highest = {10.0, 1.0}};
  Raster forward(box, {1.0, 1.0}), backward(box, {1.0, 1.0});
  forward.stamp({2.5, 0.5}, 4.0, 1);
  forward.stamp({6.4, 0.5}, 4.0, 2);
  backward.stamp({6.4, 0.5}, 4.0, 2);
  backward.stamp({2.5, 0.5}, 4.0, 1);
  EXPECT_EQ(forward.pixels(), backward.pixels());
  EXPECT_THAT(forward.pixels(), testing::ElementsAre(1, 1, 1, 1, 2, 2, 2, 2, 2, 2));
}

TEST(Raster, IgnoresWhatLiesOutside) {
  Raster raster({.lowest = {0.0, 0.0}, .highest = {4.0, 3.0}}, {1.0, 1.0});
  raster.stamp({1e12, -1e12}, 0.5, 3);
  raster.fill({{{-9.0, 0.0}, {-8.0, 0.0}, {-8.0, 1.0}, {-9.0, 1.0}}}, 3);
  EXPECT_THAT(raster.pixels(), testing::Each(Raster::background));
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    number = number << 8U | static_cast<unsigned char>(bytes[i]);
  return number;
}

TEST(Png, HoldsThePixelsAndThePalette) {
  Raster raster({.lowest = {0.0, 0.0}, .highest = {3.0, 2.0}}, {1.0, 1.0});
  raster.stamp({0.5, 0.5}, 0.1, 1);
  raster.stamp({2.5, 1.5}, 0.1, 2);
  const std::string file = png(raster, {{255, 255, 255}, {1, 2, 3}, {4, 5, 6}});
  ASSERT_EQ(file.substr(0, 8), "\x89PNG\r\n\x1a\n");
  std::map<std::string, std::string> chunks;
  for (std::size_t at = 8; at < file.size(); at += 12 + number_at(file, at)) {
    const std::string checked = file.substr(at + 4, 4 + number_at(file, at));
    EXPECT_EQ(number_at(file, at + 4 + checked.size()),
              crc32(0, reinterpret_cast<const Bytef*>(checked.data()), static_cast<uInt>(checked.size())));
    chunks[checked.substr(0, 4)] = checked.substr(4);
  }
  EXPECT_EQ(number_at(chunks["IHDR"], 0), 3U);
  EXPECT_EQ(number_at(chunks["IHDR"], 4), 2U);
  EXPECT_EQ(chunks["PLTE"], std::string("\xff\xff\xff\x01\x02\x03\x04\x05\x06"));
  std::string rows(8, 'x');
  uLongf size = rows.size();
  ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(rows.data()), &size,
                       reinterpret_cast<const Bytef*>(chunks["IDAT"].data()), chunks["IDAT"].size()),
            Z_OK);
  EXPECT_EQ(rows, std::string("\0\0\0\2\0\1\0\0", 8));
}

TEST(Png, BecomesAnAddress) {
  EXPECT_EQ(data_address("Ma"), "data:image/png;base64,TWE=");
}

TEST(ChartFrame, HasRoundValuesWithinTheAxis) {
  EXPECT_THAT(round_values(0.0, 0.3232, 6),
              testing::ElementsAre(0.0, 0.1, testing::DoubleEq(0.2), testing::DoubleEq(0.3)));
  EXPECT_THAT(round_values(-3.0, 3.0, 4), testing::ElementsAre(-2.0, 0.0, 2.0));
  EXPECT_EQ(round_values(5.0, 5.0, 4).size(), 1U);
}

TEST(ChartFrame, WritesTinyValuesInPowersOfAThousand) {
  const AxisText tiny = axis_text({.lowest = 0.0, .highest = 9.98e-5, .title = "Settlement", .unit = "m"}, 6);
  EXPECT_EQ(tiny.title, "Settlement [10⁻⁶ m]");
  EXPECT_THAT(tiny.labels, testing::ElementsAre("0", "20", "40", "60", "80"));
  const AxisText usual = axis_text({.lowest = -0.2, .highest = 0.2, .title = "Settlement", .unit = "m"}, 5);
  EXPECT_EQ(usual.title, "Settlement [m]");
  EXPECT_THAT(usual.labels, testing::ElementsAre("−0.2", "−0.1", "0.0", "0.1", "0.2"));
}

} // namespace
} // namespace settle::compare::test
