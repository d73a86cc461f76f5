#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "conceptplan/domain/object.hpp"
#include "conceptplan/domain/object_crop.hpp"
#include "conceptplan/domain/simulation/concept_set.hpp"
#include "conceptplan/domain/task.hpp"

namespace conceptplan {

/// Which part of the concept set is stored.
struct ConceptDatasetOptions {
  Split split = Split::kTrain;
  int samples = kNumColorSamples;  ///< pictures a combination, in [1, 20]
  RenderDomain domain = RenderDomain::kStandard;
  std::uint64_t seed = 0;  ///< of the `ConceptSet`
  bool operator==(const ConceptDatasetOptions&) const = default;
};

/// One object alone, and what it is.
struct ConceptSample {
  ObjectState object;
  int sample = 0;  ///< in [0, samples); its colours are those of `ConceptSet::appearance`
  ObjectCrop crop;
};

/// Foreground pictures of a split of the concept set on disk. docs/datasets.md describes its files.
/// They are mapped into memory, so that opening is cheap and only what is read is loaded.
/// Immutable, thread-safe.
class ConceptDataset {
 public:
  /// @throws InputError with all faults: a file missing, truncated or of another version or kind,
  ///   or a set whose generation was interrupted.
  explicit ConceptDataset(const std::filesystem::path& folder);
  ~ConceptDataset();
  ConceptDataset(ConceptDataset&&) noexcept;
  ConceptDataset& operator=(ConceptDataset&&) noexcept;

  const std::filesystem::path& folder() const;
  const ConceptDatasetOptions& options() const;

  /// Of the combinations in this set.
  const std::vector<CombinationId>& combinations() const;

  /// Samples in all: combinations x samples.
  std::size_t size() const;

  /// Position of a sample: combinations ascending, the samples of one follow each other.
  /// @throws std::invalid_argument if the combination or the sample is not in this set.
  std::size_t position(CombinationId combination, int sample) const;

  /// Depth is stored in tenths of a millimetre.
  /// @throws std::invalid_argument if `position >= size()`.
  /// @throws InputError if the record is damaged, or has no pixel on its object.
  ConceptSample sample(std::size_t position) const;

 private:
  struct Content;
  std::unique_ptr<const Content> content_;
};

}  // namespace conceptplan
