#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "conceptplan/domain/image.hpp"

namespace conceptplan {

/// The three PNG files of one RGB-D picture: 8-bit RGB, 16-bit grey depth in millimetres and 8-bit
/// grey instance ids.
struct RgbdPaths {
  std::filesystem::path rgb;
  std::filesystem::path depth;
  std::filesystem::path mask;
};

/// STEM.rgb.png, STEM.depth.png and STEM.mask.png.
RgbdPaths rgbdPaths(const std::filesystem::path& stem);

/// Writes the three files of a picture, each atomically. Depth is rounded to millimetres and cut
/// at 65.535 m; colours and ids are kept exactly.
/// @throws std::invalid_argument if a channel has another size than width x height.
/// @throws InputError, std::runtime_error as `writeFileAtomically`.
void writeRgbdImage(const std::filesystem::path& stem, const RgbdImage& image);

/// Reads a picture of any size up to 8192 x 8192. An alpha channel of the RGB file is ignored.
/// @throws InputError with ALL faults: a file missing, not a PNG, truncated or damaged (the
///   checksums of the PNG are checked), of another bit depth or colour type, or sizes that differ.
///   The key of a fault is "rgb", "depth" or "mask".
RgbdImage readRgbdImage(const RgbdPaths& paths);

/// A colour picture as the bytes of a PNG file. Equal pictures give equal bytes.
/// @param rgb [height, width, 3]
/// @throws std::invalid_argument if the sizes do not fit.
std::string encodePng(int width, int height, std::span<const std::uint8_t> rgb);

/// Reads a colour picture; depth and mask stay empty.
/// @throws InputError as `readRgbdImage`.
RgbdImage readRgbImage(const std::filesystem::path& path);

}  // namespace conceptplan
