#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace conceptplan {

/// CRC-32 as in zlib, PNG and gzip: finds damage, does not withstand forgery.
/// `crc32("123456789") == 0xcbf43926`.
std::uint32_t crc32(std::string_view bytes);

/// The checksum of a file's bytes, read in pieces.
/// @throws InputError if the file is missing or unreadable.
std::uint32_t crc32OfFile(const std::filesystem::path& path);

/// Eight lower-case hexadecimal digits.
std::string hexadecimal(std::uint32_t checksum);

}  // namespace conceptplan
