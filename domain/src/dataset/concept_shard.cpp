#include "dataset/concept_shard.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "conceptplan/domain/dataset/concept_dataset_writer.hpp"
#include "conceptplan/domain/files/checksum.hpp"
#include "conceptplan/domain/input_error.hpp"

static_assert(std::endian::native == std::endian::little, "shards are little-endian");

namespace conceptplan {
namespace {

constexpr std::size_t kPixels = static_cast<std::size_t>(ObjectCrop::kEdge) * ObjectCrop::kEdge;
constexpr double kDepthsPerMetre = 10000;

struct ShardHeader {
  std::array<char, 8> magic{'C', 'P', 'C', 'R', 'O', 'P', 'S', '\n'};
  std::uint32_t version = 1;
  std::uint32_t edge = ObjectCrop::kEdge;
  std::uint32_t record_bytes = kConceptRecordBytes;
  std::uint32_t num_records = 0;
  std::uint64_t first_record = 0;
};
static_assert(sizeof(ShardHeader) == kShardHeaderBytes);

struct RecordHeader {
  std::array<std::uint8_t, 6> values{};  // one a concept
  std::uint8_t sample = 0;
  std::uint8_t reserved = 0;
  std::int16_t left = 0;
  std::int16_t top = 0;
  std::uint32_t crc32 = 0;  // of the record with this field 0
};
static_assert(sizeof(RecordHeader) + kPixels * 5 == kConceptRecordBytes);

void check(const ObjectCrop& crop) {
  if (crop.rgb.size() != kPixels * 3 || crop.depth_m.size() != kPixels ||
      crop.mask.size() != kPixels)
    throw std::invalid_argument("a crop must be 64 x 64, not one of " +
                                std::to_string(crop.mask.size()) + " pixels");
  if (std::ranges::count(crop.mask, 0) == static_cast<std::ptrdiff_t>(kPixels))
    throw std::invalid_argument("a crop has no pixel on its object");
  constexpr int kHighest = std::numeric_limits<std::int16_t>::max();
  if (std::max(std::abs(crop.left), std::abs(crop.top)) > kHighest)
    throw std::invalid_argument("a crop at (" + std::to_string(crop.left) + ", " +
                                std::to_string(crop.top) + ") is too far from its frame");
}

std::uint16_t depthInTenths(float depth_m, bool masked) {
  const double depth = std::round(static_cast<double>(depth_m) * kDepthsPerMetre);
  if ((depth > 0) != masked || depth < 0 || depth > std::numeric_limits<std::uint16_t>::max())
    throw std::invalid_argument("depth " + std::to_string(depth_m) + " m of a pixel " +
                                (masked ? "on" : "off") + " the object");
  return static_cast<std::uint16_t>(depth);
}

}  // namespace

std::string shardName(std::size_t shard) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "concepts-%05zu.bin", shard);
  return name.data();
}

std::size_t numShards(std::size_t num_samples) {
  return (num_samples + ConceptDatasetWriter::kShardSize - 1) / ConceptDatasetWriter::kShardSize;
}

std::size_t shardLength(std::size_t shard, std::size_t num_samples) {
  constexpr std::size_t kSize = ConceptDatasetWriter::kShardSize;
  return std::min(kSize, num_samples - std::min(num_samples, shard * kSize));
}

std::string shardHeader(std::size_t shard, std::size_t num_samples) {
  ShardHeader header;
  header.num_records = static_cast<std::uint32_t>(shardLength(shard, num_samples));
  header.first_record = shard * ConceptDatasetWriter::kShardSize;
  std::string bytes(sizeof(header), '\0');
  std::memcpy(bytes.data(), &header, sizeof(header));
  return bytes;
}

void appendConceptRecord(const ObjectState& object, int sample, const ObjectCrop& crop,
                         std::string& bytes) {
  check(crop);
  RecordHeader header;
  for (const Concept which : kConcepts)
    header.values[index(which)] = static_cast<std::uint8_t>(valueOf(object, which));
  header.sample = static_cast<std::uint8_t>(sample);
  header.left = static_cast<std::int16_t>(crop.left);
  header.top = static_cast<std::int16_t>(crop.top);

  std::string record(kConceptRecordBytes, '\0');
  std::memcpy(record.data(), &header, sizeof(header));
  std::memcpy(record.data() + sizeof(header), crop.rgb.data(), kPixels * 3);
  char* const depths = record.data() + sizeof(header) + kPixels * 3;
  for (std::size_t i = 0; i < kPixels; ++i) {
    const std::uint16_t depth = depthInTenths(crop.depth_m[i], crop.mask[i] != 0);
    std::memcpy(depths + 2 * i, &depth, sizeof(depth));
  }
  header.crc32 = crc32(record);
  std::memcpy(record.data(), &header, sizeof(header));
  bytes += record;
}

ConceptSample parseConceptRecord(std::string_view bytes, const std::filesystem::path& path) {
  RecordHeader header;
  std::memcpy(&header, bytes.data(), sizeof(header));
  const std::uint32_t expected = header.crc32;
  header.crc32 = 0;
  std::string record(bytes);
  std::memcpy(record.data(), &header, sizeof(header));
  if (crc32(record) != expected)
    throw InputError({{path.string(), {}, {}, "", "a record is damaged: its checksum is wrong"}});

  ConceptSample sample;
  sample.object = {static_cast<ObjectType>(header.values[0]),
                   {header.values[1], header.values[2]},
                   header.values[3],
                   header.values[4],
                   header.values[5]};
  sample.sample = header.sample;
  ObjectCrop& crop = sample.crop;
  crop.left = header.left;
  crop.top = header.top;
  crop.rgb.resize(kPixels * 3);
  std::memcpy(crop.rgb.data(), record.data() + sizeof(header), kPixels * 3);
  crop.depth_m.resize(kPixels);
  crop.mask.resize(kPixels);
  const char* const depths = record.data() + sizeof(header) + kPixels * 3;
  for (std::size_t i = 0; i < kPixels; ++i) {
    std::uint16_t depth = 0;
    std::memcpy(&depth, depths + 2 * i, sizeof(depth));
    crop.depth_m[i] = static_cast<float>(depth / kDepthsPerMetre);
    crop.mask[i] = depth > 0;
  }
  return sample;
}

}  // namespace conceptplan
