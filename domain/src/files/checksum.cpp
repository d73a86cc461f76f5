#include "conceptplan/domain/files/checksum.hpp"

#include <zlib.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "conceptplan/domain/files/json_depth.hpp"
#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

uLong extend(uLong checksum, std::string_view bytes) {
  return ::crc32_z(checksum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
}

}  // namespace

std::uint32_t crc32(std::string_view bytes) { return static_cast<std::uint32_t>(extend(0, bytes)); }

std::uint32_t crc32OfFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError({Fault{path.string(), {}, {}, "", "file not found or unreadable"}});
  std::array<char, 1 << 16> piece;
  uLong checksum = 0;
  while (file.read(piece.data(), piece.size()) || file.gcount() > 0) {
    checksum = extend(checksum, {piece.data(), static_cast<std::size_t>(file.gcount())});
  }
  if (file.bad()) throw InputError({Fault{path.string(), {}, {}, "", "reading failed"}});
  return static_cast<std::uint32_t>(checksum);
}

std::uint32_t crc32OfJson(std::string_view object) {
  if (nestsTooDeep(object)) return 0;
  nlohmann::json document = nlohmann::json::parse(object, nullptr, /*allow_exceptions=*/false);
  if (!document.is_object()) return 0;
  document.erase("checksum");
  return crc32(document.dump());
}

std::string hexadecimal(std::uint32_t checksum) {
  static constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(8, '0');
  for (std::size_t i = 8; i-- > 0; checksum >>= 4) text[i] = kDigits[checksum & 15u];
  return text;
}

}  // namespace conceptplan
