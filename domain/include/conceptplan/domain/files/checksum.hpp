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

/// The checksum of what a JSON object says, whatever its white space and the order of its members:
/// of all of them but "checksum", where a file may hold it.
/// @returns 0 if the text is not a JSON object, or nested too deeply
std::uint32_t crc32OfJson(std::string_view object);

/// Eight lower-case hexadecimal digits.
std::string hexadecimal(std::uint32_t checksum);

}  // namespace conceptplan
