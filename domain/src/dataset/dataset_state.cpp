#include "conceptplan/domain/dataset/dataset_state.hpp"

#include "dataset/manifest.hpp"

namespace conceptplan {
namespace {

DatasetState stateOf(const std::filesystem::path& folder, const std::string& kind,
                     const nlohmann::json& options) {
  if (!wasBegun(folder)) return DatasetState::kMissing;
  const Manifest manifest = readManifest(folder);
  expectDataset(manifest, folder, kind, options);
  return manifest.complete ? DatasetState::kComplete : DatasetState::kInterrupted;
}

}  // namespace

DatasetState datasetState(const std::filesystem::path& folder, const TaskDatasetOptions& options) {
  return stateOf(folder, "tasks", toJson(options));
}

DatasetState datasetState(const std::filesystem::path& folder,
                          const ConceptDatasetOptions& options) {
  return stateOf(folder, "concepts", toJson(options));
}

}  // namespace conceptplan
