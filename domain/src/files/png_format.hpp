#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace conceptplan {

/// What the header of a PNG file says.
struct PngHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  int bit_depth = 0;   ///< of one channel
  int color_type = 0;  ///< 0 grey, 2 RGB, 3 palette, 4 grey + alpha, 6 RGB + alpha

  /// E.g. "8-bit RGB".
  std::string text() const;
};

/// Walks all chunks of a PNG file and checks their lengths and checksums, since image libraries
/// return a part of a truncated picture without a word.
/// @returns the header, or nothing with the reason in `fault`.
std::optional<PngHeader> checkPng(std::string_view bytes, std::string& fault);

}  // namespace conceptplan
