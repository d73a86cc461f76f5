#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "conceptplan/domain/dataset/concept_dataset.hpp"

namespace conceptplan {

/// Writes a part of the concept set, shard by shard. The folder is a valid set only after `finish`;
/// until then it can be continued by a writer of the same options, which keeps complete shards.
class ConceptDatasetWriter {
 public:
  /// Samples in a shard; the last one may have fewer.
  static constexpr std::size_t kShardSize = 960;

  /// A picture to be made.
  struct Request {
    ObjectState object;
    int sample;
    std::uint64_t appearance;  ///< seed
  };

  /// Begins or continues the set.
  /// @throws InputError if the folder holds another dataset or cannot be written.
  /// @throws std::invalid_argument for samples outside [1, 20].
  ConceptDatasetWriter(const std::filesystem::path& folder, const ConceptDatasetOptions& options);

  std::size_t numShards() const;

  /// The shards that are not there yet, ascending.
  std::vector<std::size_t> pendingShards() const;

  /// What a shard holds, in order. @pre shard < numShards()
  std::vector<Request> requests(std::size_t shard) const;

  /// Writes a shard: one crop a request, in order. Thread-safe for different shards.
  /// @throws std::invalid_argument if a crop has another shape or no pixel on its object, or depth
  ///   outside its mask or none within it, or beyond 6.5535 m.
  /// @throws InputError, std::runtime_error as `writeFileAtomically`.
  void write(std::size_t shard, std::span<const ObjectCrop> crops) const;

  /// Writes the checksums and declares the set complete.
  /// @throws InputError if a shard is missing.
  void finish() const;

 private:
  std::filesystem::path folder_;
  ConceptDatasetOptions options_;
  ConceptSet set_;
};

}  // namespace conceptplan
