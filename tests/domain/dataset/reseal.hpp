#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/checksum.hpp"

namespace conceptplan {

inline void overwrite(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// Writes a checksum where a JSON text has that of the key, if it has one.
inline void setChecksum(std::string& text, const std::string& key, std::uint32_t checksum) {
  const std::string start = '"' + key + "\": \"";
  const std::size_t at = text.find(start);
  if (at != std::string::npos) text.replace(at + start.size(), 8, hexadecimal(checksum));
}

/// Makes the checksums of a JSON file right again after a change, as who forges one would.
inline void resealJson(const std::filesystem::path& file) {
  std::string text = readFile(file);
  setChecksum(text, "checksum", crc32OfJson(text));
  overwrite(file, text);
}

/// The same for all files of a dataset.
inline void resealDataset(const std::filesystem::path& folder) {
  std::istringstream old(readFile(folder / "checksums.txt"));
  std::string lines, digits, bytes, path;
  while (old >> digits >> bytes >> path)
    lines += hexadecimal(crc32OfFile(folder / path)) + ' ' +
             std::to_string(std::filesystem::file_size(folder / path)) + ' ' + path + '\n';
  overwrite(folder / "checksums.txt", lines);
  std::string manifest = readFile(folder / "dataset.json");
  setChecksum(manifest, "checksums", crc32(lines));
  overwrite(folder / "dataset.json", manifest);
  resealJson(folder / "dataset.json");
}

/// Bytes of a record of a concept set, and of what is before the first of a file.
inline constexpr std::size_t kRecordBytes = 16 + std::size_t{64} * 64 * 5;
inline constexpr std::size_t kRecordsBegin = 32;

/// The same for one record of a file of a concept set.
inline void resealRecord(std::string& bytes, std::size_t record) {
  const std::size_t begin = kRecordsBegin + record * kRecordBytes, at = begin + 12;
  bytes.replace(at, 4, 4, '\0');
  const std::uint32_t checksum = crc32(std::string_view(bytes).substr(begin, kRecordBytes));
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<char>(checksum >> 8 * i & 255u);
}

}  // namespace conceptplan
