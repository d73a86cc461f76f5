#include "conceptplan/domain/dataset/concept_dataset_writer.hpp"

#include <stdexcept>
#include <string>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "dataset/concept_shard.hpp"
#include "dataset/manifest.hpp"

namespace conceptplan {
namespace {

std::size_t numSamples(const ConceptSet& set, const ConceptDatasetOptions& options) {
  return set.combinations(options.split).size() * static_cast<std::size_t>(options.samples);
}

}  // namespace

ConceptDatasetWriter::ConceptDatasetWriter(const std::filesystem::path& folder,
                                           const ConceptDatasetOptions& options)
    : folder_(folder), options_(options), set_(options.seed) {
  if (options.samples < 1 || options.samples > kNumColorSamples)
    throw std::invalid_argument("samples must be in [1, " + std::to_string(kNumColorSamples) +
                                "], not " + std::to_string(options.samples));
  beginDataset(folder_, "concepts", toJson(options_));
}

std::size_t ConceptDatasetWriter::numShards() const {
  return conceptplan::numShards(numSamples(set_, options_));
}

std::vector<std::size_t> ConceptDatasetWriter::pendingShards() const {
  std::vector<std::size_t> pending;
  for (std::size_t shard = 0; shard < numShards(); ++shard)
    if (!std::filesystem::exists(folder_ / shardName(shard))) pending.push_back(shard);
  return pending;
}

std::vector<ConceptDatasetWriter::Request> ConceptDatasetWriter::requests(std::size_t shard) const {
  if (shard >= numShards())
    throw std::invalid_argument("shard " + std::to_string(shard) + " of " +
                                std::to_string(numShards()));
  const auto samples = static_cast<std::size_t>(options_.samples);
  std::vector<Request> requests(shardLength(shard, numSamples(set_, options_)));
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const std::size_t position = shard * kShardSize + i;
    const CombinationId combination = set_.combinations(options_.split)[position / samples];
    const int sample = static_cast<int>(position % samples);
    requests[i] = {objectOf(combination), sample, set_.appearance(combination, sample)};
  }
  return requests;
}

void ConceptDatasetWriter::write(std::size_t shard, std::span<const ObjectCrop> crops) const {
  const std::vector<Request> wanted = requests(shard);
  if (crops.size() != wanted.size())
    throw std::invalid_argument("shard " + std::to_string(shard) + " has " +
                                std::to_string(wanted.size()) + " crops, not " +
                                std::to_string(crops.size()));
  std::string bytes = shardHeader(shard, numSamples(set_, options_));
  bytes.reserve(bytes.size() + wanted.size() * kConceptRecordBytes);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    appendConceptRecord(wanted[i].object, wanted[i].sample, crops[i], bytes);
  writeFileAtomically(folder_ / shardName(shard), bytes);
}

void ConceptDatasetWriter::finish() const {
  std::vector<std::string> paths;
  for (std::size_t shard = 0; shard < numShards(); ++shard) paths.push_back(shardName(shard));
  finishDataset(folder_, "concepts", toJson(options_), paths);
}

}  // namespace conceptplan
