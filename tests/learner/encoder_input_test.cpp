#include "conceptplan/learner/encoder_input.hpp"

#include <gmock/gmock.h>

#include "learner/random_crops.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kPixels = EncoderInput::kPixels;
constexpr std::size_t kCenter = 32 * 64 + 32;

TEST(EncoderInput, KeepsColoursOfTheObjectAndNothingElse) {
  ObjectCrop crop = coloredBlob(1);
  crop.rgb[0] = 99;  // outside the mask
  const EncoderInput input = encoderInput(crop);
  for (std::size_t channel = 0; channel < 3; ++channel)
    EXPECT_EQ(input.planes[channel * kPixels + kCenter], crop.rgb[3 * kCenter + channel]);
  EXPECT_EQ(input.planes[0], 0);
  EXPECT_EQ(input.planes[4 * kPixels + kCenter], 255);
  EXPECT_EQ(input.planes[4 * kPixels], 0);
}

TEST(EncoderInput, MeasuresDepthInMillimetresFromItsMedian) {
  const EncoderInput input = encoderInput(coloredBlob(1));
  EXPECT_EQ(input.planes[3 * kPixels + kCenter], 128);
  EXPECT_NEAR(input.planes[3 * kPixels + kCenter + 5 * 64], 133, 1);
  EXPECT_NEAR(input.location[2], 0.0, 1e-3);
}

TEST(EncoderInput, LocatesTheCropInTheFrame) {
  ObjectCrop crop = coloredBlob(1);
  crop.left = kFrameWidth / 2 - 32;
  crop.top = kFrameHeight / 2;
  const EncoderInput input = encoderInput(crop);
  EXPECT_FLOAT_EQ(input.location[0], 0.0F);
  EXPECT_FLOAT_EQ(input.location[1], 0.25F);
}

TEST(EncoderInput, RefusesAnEmptyOrMisshapenCrop) {
  ObjectCrop crop = coloredBlob(1);
  crop.mask.assign(kPixels, 0);
  EXPECT_THAT([&] { encoderInput(crop); },
              testing::ThrowsMessage<std::invalid_argument>(
                  testing::HasSubstr("no pixel of the crop is on the object")));
  crop.mask.pop_back();
  EXPECT_THAT([&] { encoderInput(crop); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("64 x 64")));
}

}  // namespace
}  // namespace conceptplan
