#include <gmock/gmock.h>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "domain/files/temporary_folder.hpp"
#include "fuzz/damage.hpp"

namespace conceptplan {
namespace {

RgbdImage sample() {
  RgbdImage image{24, 16, {}, {}, {}};
  for (int i = 0; i < 24 * 16; ++i) {
    for (int channel = 0; channel < 3; ++channel)
      image.rgb.push_back(static_cast<std::uint8_t>(i * (channel + 1)));
    image.depth_m.push_back(1.5F + 0.001F * static_cast<float>(i));
    image.mask.push_back(static_cast<std::uint8_t>(i % 5 == 0));
  }
  return image;
}

TEST(PictureFuzz, DamagedFilesAreRefusedOrShowTheSamePicture) {
  const TemporaryFolder folder;
  writeRgbdImage(folder / "p", sample());
  const RgbdPaths paths = rgbdPaths(folder / "p");
  const RgbdImage whole = readRgbdImage(paths);
  for (const auto& path : {paths.rgb, paths.depth, paths.mask}) {
    const std::string bytes = readFile(path);
    std::size_t refused = 0;
    testing::forEachDamage(bytes, 100, 300, 17,
                           [&](const std::string& damaged, const std::string& what) {
                             SCOPED_TRACE(path.filename().string() + ", " + what);
                             folder.write(path.filename().string(), damaged);
                             try {
                               const RgbdImage read = readRgbdImage(paths);
                               EXPECT_EQ(read.rgb, whole.rgb);
                               EXPECT_EQ(read.depth_m, whole.depth_m);
                               EXPECT_EQ(read.mask, whole.mask);
                             } catch (const InputError&) {
                               ++refused;
                             }
                           });
    EXPECT_GT(refused, 350U);
    folder.write(path.filename().string(), bytes);
  }
}

}  // namespace
}  // namespace conceptplan
