#include "conceptplan/learner/training/augmentation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "learner/random_crops.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kPixels = EncoderInput::kPixels;

std::ptrdiff_t visible(const EncoderInput& input) {
  return std::count(input.planes.begin() + 4 * kPixels, input.planes.end(), 255);
}

TEST(Augmentation, WithNothingToVaryKeepsTheImage) {
  const EncoderInput input = encoderInput(coloredBlob(2));
  std::mt19937_64 generator(1);
  const EncoderInput same =
      augmented(input.planes, input.location, input.planes, kNoAugmentation, generator);
  // The blob's bounding box is off the middle by one pixel, which centring mends.
  EXPECT_EQ(visible(same), visible(input));
  EXPECT_NEAR(same.location[0], input.location[0], 0.006);
}

TEST(Augmentation, OcclusionHidesAPartAndKeepsAtLeastTwoFifths) {
  const EncoderInput input = encoderInput(coloredBlob(2, 18));
  const EncoderInput occluder = encoderInput(coloredBlob(3, 24));
  AugmentationOptions options = kNoAugmentation;
  options.occlusion = 1;
  std::mt19937_64 generator(1);
  bool hidden = false;
  for (int draw = 0; draw < 100; ++draw) {
    const EncoderInput varied =
        augmented(input.planes, input.location, occluder.planes, options, generator);
    hidden = hidden || visible(varied) < visible(input);
    EXPECT_GE(visible(varied), 2 * visible(input) / 5 - 1);
  }
  EXPECT_TRUE(hidden);
}

TEST(Augmentation, MaskNoiseTakesPixelsFromTheOutlineAlone) {
  const EncoderInput input = encoderInput(coloredBlob(2, 18));
  AugmentationOptions options = kNoAugmentation;
  options.mask_noise = 1;
  std::mt19937_64 first(1), second(1);
  const EncoderInput whole =
      augmented(input.planes, input.location, input.planes, kNoAugmentation, first);
  const EncoderInput frayed =
      augmented(input.planes, input.location, input.planes, options, second);
  const auto lost = visible(whole) - visible(frayed);
  EXPECT_GT(lost, 10);
  EXPECT_LT(lost, 4 * 2 * 18);  // no more than the outline of a box around it
}

TEST(Augmentation, SameGeneratorSameImage) {
  const EncoderInput input = encoderInput(coloredBlob(2));
  std::mt19937_64 first(5), second(5), third(6);
  const AugmentationOptions options;
  const auto vary = [&](std::mt19937_64& generator) {
    return augmented(input.planes, input.location, input.planes, options, generator).planes;
  };
  const auto planes = vary(first);
  EXPECT_EQ(planes, vary(second));
  EXPECT_NE(planes, vary(third));
}

TEST(Augmentation, NeverColoursTheBackground) {
  const EncoderInput input = encoderInput(coloredBlob(2));
  std::mt19937_64 generator(9);
  for (int draw = 0; draw < 20; ++draw) {
    const EncoderInput varied =
        augmented(input.planes, input.location, input.planes, AugmentationOptions{}, generator);
    for (std::size_t i = 0; i < kPixels; ++i) {
      if (varied.planes[4 * kPixels + i] != 0) continue;
      for (std::size_t channel = 0; channel < 4; ++channel)
        ASSERT_EQ(varied.planes[channel * kPixels + i], 0);
    }
  }
}

}  // namespace
}  // namespace conceptplan
