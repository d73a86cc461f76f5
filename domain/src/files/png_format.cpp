#include "png_format.hpp"

#include "conceptplan/domain/files/checksum.hpp"

namespace conceptplan {
namespace {

constexpr std::string_view kSignature{"\x89PNG\r\n\x1a\n", 8};
constexpr std::size_t kChunkFrame = 12;  // length, type and checksum
constexpr std::size_t kHeaderLength = 13;

std::uint32_t bigEndian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

PngHeader parseHeader(std::string_view data) {
  return {bigEndian(data), bigEndian(data.substr(4)), static_cast<unsigned char>(data[8]),
          static_cast<unsigned char>(data[9])};
}

}  // namespace

std::string PngHeader::text() const {
  std::string type = "unknown colour type " + std::to_string(color_type);
  switch (color_type) {
    case 0:
      type = "grey";
      break;
    case 2:
      type = "RGB";
      break;
    case 3:
      type = "palette";
      break;
    case 4:
      type = "grey with alpha";
      break;
    case 6:
      type = "RGB with alpha";
      break;
    default:
      break;
  }
  return std::to_string(bit_depth) + "-bit " + type;
}

std::optional<PngHeader> checkPng(std::string_view bytes, std::string& fault) {
  const auto refuse = [&fault](std::string reason) {
    fault = std::move(reason);
    return std::nullopt;
  };
  if (bytes.empty()) return refuse("the file is empty");
  if (!bytes.starts_with(kSignature)) {
    return refuse(kSignature.starts_with(bytes) ? "truncated PNG" : "not a PNG file");
  }
  const std::size_t total = bytes.size();
  const auto truncated = [&] {
    return refuse("truncated PNG: the file ends after " + std::to_string(total) +
                  " bytes without its end mark");
  };
  std::optional<PngHeader> header;
  bool has_data = false;
  for (std::string_view rest = bytes.substr(kSignature.size()); !rest.empty();) {
    if (rest.size() < kChunkFrame) return truncated();
    const std::size_t length = bigEndian(rest);
    if (length > rest.size() - kChunkFrame) return truncated();
    const std::string_view type = rest.substr(4, 4);
    const std::string_view data = rest.substr(8, length);
    if (crc32(rest.substr(4, 4 + length)) != bigEndian(rest.substr(8 + length))) {
      return refuse("damaged PNG: wrong checksum of the chunk at byte " +
                    std::to_string(total - rest.size()));
    }
    if (!header) {
      if (type != "IHDR" || length != kHeaderLength) return refuse("damaged PNG: no header");
      header = parseHeader(data);
    }
    has_data = has_data || type == "IDAT";
    if (type == "IEND") return has_data ? header : refuse("damaged PNG: no picture data");
    rest.remove_prefix(kChunkFrame + length);
  }
  return truncated();
}

}  // namespace conceptplan
