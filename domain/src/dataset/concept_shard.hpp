#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "conceptplan/domain/dataset/concept_dataset.hpp"

namespace conceptplan {

/// Bytes of one record: what the object is, where its crop lies, a checksum, and the pixels.
inline constexpr std::size_t kConceptRecordBytes =
    16 + static_cast<std::size_t>(ObjectCrop::kEdge) * ObjectCrop::kEdge * 5;

/// Bytes before the first record of a shard.
inline constexpr std::size_t kShardHeaderBytes = 32;

/// "concepts-00007.bin".
std::string shardName(std::size_t shard);

/// Number of shards of that many samples.
std::size_t numShards(std::size_t num_samples);

/// Samples in a shard.
std::size_t shardLength(std::size_t shard, std::size_t num_samples);

std::string shardHeader(std::size_t shard, std::size_t num_samples);

/// @throws std::invalid_argument as `ConceptDatasetWriter::write`.
void appendConceptRecord(const ObjectState& object, int sample, const ObjectCrop& crop,
                         std::string& bytes);

/// @param bytes of one record
/// @throws InputError, in the name of `path`, if the checksum does not fit.
ConceptSample parseConceptRecord(std::string_view bytes, const std::filesystem::path& path);

}  // namespace conceptplan
