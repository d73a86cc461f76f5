#include "conceptplan/domain/files/rgbd_image_file.hpp"

#include <gmock/gmock.h>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/checksum.hpp"
#include "domain/files/temporary_folder.hpp"

namespace conceptplan {
namespace {

using testing::HasSubstr;
using testing::Not;

RgbdImage sampleImage(int width, int height) {
  RgbdImage image{width, height, {}, {}, {}};
  for (int i = 0; i < width * height; ++i) {
    for (int channel = 0; channel < 3; ++channel) {
      image.rgb.push_back(static_cast<std::uint8_t>(i * 7 + channel * 31));
    }
    image.depth_m.push_back(0.001f * static_cast<float>(i * 13 % 4000));
    image.mask.push_back(static_cast<std::uint8_t>(i % 4));
  }
  return image;
}

std::string replaced(std::string text, std::size_t position, char value) {
  text[position] = value;
  return text;
}

TEST(RgbdImageFile, RoundTripKeepsEveryPixel) {
  const TemporaryFolder folder;
  const RgbdImage image = sampleImage(17, 9);
  writeRgbdImage(folder / "view.1", image);
  const RgbdImage read = readRgbdImage(rgbdPaths(folder / "view.1"));
  EXPECT_EQ(read.width, 17);
  EXPECT_EQ(read.height, 9);
  EXPECT_EQ(read.rgb, image.rgb);
  EXPECT_EQ(read.mask, image.mask);
  ASSERT_EQ(read.depth_m.size(), image.depth_m.size());
  for (std::size_t i = 0; i < read.depth_m.size(); ++i) {
    EXPECT_NEAR(read.depth_m[i], image.depth_m[i], 0.0005f);
  }
  EXPECT_EQ(readRgbImage(folder / "view.1.rgb.png").rgb, image.rgb);
  EXPECT_EQ(folder.fileCount(), 3u);
}

TEST(RgbdImageFile, DepthIsRoundedAndCut) {
  const TemporaryFolder folder;
  RgbdImage image = sampleImage(3, 1);
  image.depth_m = {1.2346f, 70.0f, 0.0f};
  writeRgbdImage(folder / "view", image);
  EXPECT_THAT(readRgbdImage(rgbdPaths(folder / "view")).depth_m,
              testing::Pointwise(testing::FloatNear(1e-5f), {1.235f, 65.535f, 0.0f}));
}

TEST(RgbdImageFile, WritingRefusesWrongSizes) {
  const TemporaryFolder folder;
  RgbdImage image = sampleImage(4, 4);
  image.mask.pop_back();
  EXPECT_THROW(writeRgbdImage(folder / "view", image), std::invalid_argument);
  EXPECT_THROW(encodePng(4, 4, std::vector<std::uint8_t>(47)), std::invalid_argument);
  EXPECT_THROW(encodePng(0, 4, {}), std::invalid_argument);
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST(RgbdImageFile, AllFaultsComeTogether) {
  const TemporaryFolder folder;
  writeRgbdImage(folder / "view", sampleImage(8, 8));
  RgbdPaths paths = rgbdPaths(folder / "view");
  std::filesystem::remove(paths.rgb);
  writeFileAtomically(paths.depth, "GIF89a of another kind");
  const std::string mask = readFile(paths.mask);
  writeFileAtomically(paths.mask, mask.substr(0, mask.size() / 2));
  const std::string faults = faultsOf([&] { readRgbdImage(paths); });
  EXPECT_THAT(faults, HasSubstr(paths.rgb.string() + ": rgb: file not found"));
  EXPECT_THAT(faults, HasSubstr(paths.depth.string() + ": depth: not a PNG file"));
  EXPECT_THAT(faults, HasSubstr(paths.mask.string() + ": mask: truncated PNG"));
}

TEST(RgbdImageFile, EveryTruncationIsFound) {
  const TemporaryFolder folder;
  writeRgbdImage(folder / "view", sampleImage(6, 5));
  const RgbdPaths paths = rgbdPaths(folder / "view");
  const std::string whole = readFile(paths.rgb);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    folder.write("view.rgb.png", whole.substr(0, size));
    EXPECT_THAT(faultsOf([&] { readRgbdImage(paths); }),
                testing::AnyOf(HasSubstr("truncated PNG"), HasSubstr("the file is empty")))
        << size;
  }
}

TEST(RgbdImageFile, EveryFlippedByteIsFound) {
  const TemporaryFolder folder;
  writeRgbdImage(folder / "view", sampleImage(6, 5));
  const RgbdPaths paths = rgbdPaths(folder / "view");
  const std::string whole = readFile(paths.mask);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    folder.write("view.mask.png", replaced(whole, i, static_cast<char>(whole[i] ^ 0x40)));
    EXPECT_THAT(faultsOf([&] { readRgbdImage(paths); }), HasSubstr("PNG")) << i;
  }
}

TEST(RgbdImageFile, PictureDataThatEndsEarlyIsFound) {
  const TemporaryFolder folder;
  const RgbdImage image = sampleImage(6, 5);
  std::string bytes = encodePng(6, 5, image.rgb);
  bytes[8 + 8 + 7] = 50;  // the header claims 50 rows, with a right checksum
  const std::uint32_t checksum = crc32(std::string_view(bytes).substr(12, 17));
  for (int i = 0; i < 4; ++i) {
    bytes[29 + static_cast<std::size_t>(i)] = static_cast<char>(checksum >> (24 - 8 * i));
  }
  const auto path = folder.write("short.png", bytes);
  EXPECT_THAT(faultsOf([&] { readRgbImage(path); }),
              HasSubstr("damaged PNG: the picture cannot be decoded"));
}

TEST(RgbdImageFile, WrongKindsAreNamed) {
  const TemporaryFolder folder;
  writeRgbdImage(folder / "view", sampleImage(8, 8));
  const RgbdPaths paths = rgbdPaths(folder / "view");
  const std::string faults = faultsOf([&] { readRgbdImage({paths.depth, paths.mask, paths.rgb}); });
  EXPECT_THAT(faults, HasSubstr("rgb: expected 8-bit RGB, found 16-bit grey"));
  EXPECT_THAT(faults, HasSubstr("depth: expected 16-bit grey (millimetres), found 8-bit grey"));
  EXPECT_THAT(faults, HasSubstr("mask: expected 8-bit grey (instance ids), found 8-bit RGB"));
}

TEST(RgbdImageFile, BothSizesAreNamed) {
  const TemporaryFolder folder;
  writeRgbdImage(folder / "small", sampleImage(4, 3));
  writeRgbdImage(folder / "large", sampleImage(8, 8));
  RgbdPaths paths = rgbdPaths(folder / "large");
  paths.mask = rgbdPaths(folder / "small").mask;
  const std::string faults = faultsOf([&] { readRgbdImage(paths); });
  EXPECT_THAT(faults, HasSubstr("mask: expected the size of the RGB picture, 8 x 8, found 4 x 3"));
  EXPECT_THAT(faults, Not(HasSubstr("depth:")));
}

TEST(RgbdImageFile, EqualPicturesGiveEqualBytes) {
  const RgbdImage image = sampleImage(30, 20);
  EXPECT_EQ(encodePng(30, 20, image.rgb), encodePng(30, 20, image.rgb));
}

}  // namespace
}  // namespace conceptplan
