#include "conceptplan/domain/dataset/dataset_summary.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "dataset/manifest.hpp"
#include "dataset/task_files.hpp"

namespace conceptplan {
namespace {

void summariseTasks(const std::filesystem::path& folder, const Manifest& manifest,
                    DatasetSummary& summary) {
  const TaskDatasetOptions options = taskOptions(manifest, folder);
  double total_length = 0;
  for (const Task& task : readTasks(folder, options)) {
    const std::size_t length = task.reference.size();
    ++summary.tasks;
    total_length += static_cast<double>(length);
    summary.max_length = std::max(summary.max_length, length);
    summary.length_histogram.resize(summary.max_length + 1);
    ++summary.length_histogram[length];
    summary.images += storedSteps(task, options.frames).size();
    for (const ObjectState& object : task.initial.objects)
      ++summary.objects[std::string(name(object.type))];
  }
  if (summary.tasks > 0) summary.mean_length = total_length / static_cast<double>(summary.tasks);
  summary.splits[std::string(name(options.split))] = summary.tasks;
}

void summariseConcepts(const std::filesystem::path& folder, const Manifest& manifest,
                       DatasetSummary& summary) {
  const ConceptDatasetOptions options = conceptOptions(manifest, folder);
  const ConceptSet set(options.seed);
  const auto samples = static_cast<std::size_t>(options.samples);
  for (const CombinationId combination : set.combinations(options.split)) {
    summary.images += samples;
    summary.objects[std::string(name(objectOf(combination).type))] += samples;
  }
  summary.splits[std::string(name(options.split))] = summary.images;
}

}  // namespace

DatasetSummary describeDataset(const std::filesystem::path& folder) {
  Manifest manifest = readManifest(folder);
  manifest = readManifest(folder, manifest.kind);
  DatasetSummary summary;
  summary.kind = manifest.kind;
  for (const auto& [key, value] : manifest.options.items())
    summary.options[key] = value.is_string() ? value.get<std::string>() : value.dump();
  try {
    for (const FileChecksum& expected : readChecksums(folder, manifest))
      std::ranges::move(faultsOf(folder, expected), std::back_inserter(summary.faults));
    (manifest.kind == "tasks" ? summariseTasks : summariseConcepts)(folder, manifest, summary);
  } catch (const InputError& error) {
    std::ranges::copy(error.faults(), std::back_inserter(summary.faults));
  }
  summary.checksums_ok = summary.faults.empty();
  return summary;
}

}  // namespace conceptplan
