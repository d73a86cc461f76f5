#include "conceptplan/domain/dataset/concept_dataset.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "conceptplan/domain/dataset/concept_dataset_writer.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "dataset/concept_shard.hpp"
#include "dataset/manifest.hpp"
#include "dataset/mapped_file.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kShardSize = ConceptDatasetWriter::kShardSize;

std::vector<Fault> faultsOfShard(const MappedFile& file, std::size_t shard,
                                 std::size_t num_samples) {
  const std::size_t expected =
      kShardHeaderBytes + shardLength(shard, num_samples) * kConceptRecordBytes;
  std::string message;
  if (file.bytes().size() != expected) {
    message = "expected " + std::to_string(expected) + " bytes, found " +
              std::to_string(file.bytes().size());
  } else if (!file.bytes().starts_with(shardHeader(shard, num_samples))) {
    message = "is not shard " + std::to_string(shard) + " of this dataset: its header differs";
  } else {
    return {};
  }
  return {{file.path().string(), {}, {}, "", std::move(message)}};
}

}  // namespace

struct ConceptDataset::Content {
  std::filesystem::path folder;
  ConceptDatasetOptions options;
  ConceptSet set{0};
  std::vector<MappedFile> shards;

  const std::vector<CombinationId>& combinations() const { return set.combinations(options.split); }
  std::size_t size() const {
    return combinations().size() * static_cast<std::size_t>(options.samples);
  }
};

ConceptDataset::ConceptDataset(const std::filesystem::path& folder) {
  auto content = std::make_unique<Content>();
  content->folder = folder;
  content->options = conceptOptions(readManifest(folder, "concepts"), folder);
  content->set = ConceptSet(content->options.seed);
  std::vector<Fault> faults;
  for (std::size_t shard = 0; shard < numShards(content->size()); ++shard) {
    try {
      content->shards.emplace_back(folder / shardName(shard));
      for (Fault& fault : faultsOfShard(content->shards.back(), shard, content->size()))
        faults.push_back(std::move(fault));
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  content_ = std::move(content);
}

ConceptDataset::~ConceptDataset() = default;
ConceptDataset::ConceptDataset(ConceptDataset&&) noexcept = default;
ConceptDataset& ConceptDataset::operator=(ConceptDataset&&) noexcept = default;

const std::filesystem::path& ConceptDataset::folder() const { return content_->folder; }
const ConceptDatasetOptions& ConceptDataset::options() const { return content_->options; }

const std::vector<CombinationId>& ConceptDataset::combinations() const {
  return content_->combinations();
}

std::size_t ConceptDataset::size() const { return content_->size(); }

std::size_t ConceptDataset::position(CombinationId combination, int sample) const {
  const auto found = std::ranges::lower_bound(combinations(), combination);
  if (found == combinations().end() || *found != combination)
    throw std::invalid_argument("combination " + std::to_string(static_cast<int>(combination)) +
                                " is not in the " + std::string(name(options().split)) + " split");
  if (sample < 0 || sample >= options().samples)
    throw std::invalid_argument("sample " + std::to_string(sample) + " is not in [0, " +
                                std::to_string(options().samples) + ")");
  return static_cast<std::size_t>(found - combinations().begin()) *
             static_cast<std::size_t>(options().samples) +
         static_cast<std::size_t>(sample);
}

ConceptSample ConceptDataset::sample(std::size_t position) const {
  if (position >= size())
    throw std::invalid_argument("sample " + std::to_string(position) + " of " +
                                std::to_string(size()));
  const MappedFile& file = content_->shards[position / kShardSize];
  ConceptSample sample = parseConceptRecord(
      file.bytes().substr(kShardHeaderBytes + position % kShardSize * kConceptRecordBytes,
                          kConceptRecordBytes),
      file.path());
  const auto refuse = [&](const std::string& message) {
    throw InputError({{file.path().string(),
                       {},
                       {},
                       "",
                       "record " + std::to_string(position % kShardSize) + message}});
  };
  const auto samples = static_cast<std::size_t>(options().samples);
  if (sample.object != objectOf(combinations()[position / samples]) ||
      sample.sample != static_cast<int>(position % samples))
    refuse(" shows another object than belongs there");
  if (std::ranges::count(sample.crop.mask, 0) == std::ssize(sample.crop.mask))
    refuse(" has no pixel on its object");
  return sample;
}

}  // namespace conceptplan
