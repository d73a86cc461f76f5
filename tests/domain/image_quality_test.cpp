#include "conceptplan/domain/image_quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace conceptplan {
namespace {

RgbdImage uniform(std::uint8_t value, int width = 24, int height = 16) {
  return {width,
          height,
          std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height), value),
          {},
          {}};
}

RgbdImage noise(std::uint64_t seed) {
  RgbdImage image = uniform(0);
  std::mt19937_64 generator(seed);
  for (auto& value : image.rgb) value = static_cast<std::uint8_t>(generator() % 256);
  return image;
}

TEST(PeakSignalToNoise, IsThatOfAConstantDifference) {
  EXPECT_NEAR(peakSignalToNoise_dB(uniform(100), uniform(110)), 20 * std::log10(25.5), 1e-9);
  EXPECT_TRUE(std::isinf(peakSignalToNoise_dB(noise(1), noise(1))));
}

TEST(StructuralSimilarity, IsOneForEqualPicturesAndNearZeroForUnrelatedOnes) {
  EXPECT_NEAR(structuralSimilarity(noise(1), noise(1)), 1, 1e-12);
  EXPECT_LT(std::abs(structuralSimilarity(noise(1), noise(2))), 0.1);
}

TEST(StructuralSimilarity, OfUniformPicturesIsTheLuminanceTermAlone) {
  const double c1 = 2.55 * 2.55;
  const double expected = (2.0 * 100 * 150 + c1) / (100.0 * 100 + 150.0 * 150 + c1);
  EXPECT_NEAR(structuralSimilarity(uniform(100), uniform(150)), expected, 1e-6);
}

TEST(ImageQuality, RefusesPicturesThatCannotBeCompared) {
  EXPECT_THROW(peakSignalToNoise_dB(uniform(1), uniform(1, 16, 24)), std::invalid_argument);
  EXPECT_THROW(structuralSimilarity(uniform(1, 8, 8), uniform(1, 8, 8)), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
