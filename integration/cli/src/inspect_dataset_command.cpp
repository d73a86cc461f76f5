#include <algorithm>

#include "commands.hpp"
#include "conceptplan/domain/dataset/dataset_summary.hpp"
#include "exit_code.hpp"

namespace conceptplan::cli {
namespace {

struct InspectDatasetOptions {
  std::string path;
};

template <typename Value>
Json objectOf(const std::map<std::string, Value>& entries) {
  Json object = Json::object();
  for (const auto& [key, value] : entries) object[key] = value;
  return object;
}

void printHistogram(Console& console, const std::vector<std::size_t>& histogram) {
  static constexpr std::size_t kWidth = 40;
  const std::size_t most = histogram.empty() ? 0 : std::ranges::max(histogram);
  TextTable table{{"length", "tasks", ""}};
  for (std::size_t length = 0; length < histogram.size(); ++length) {
    const std::size_t bar = most == 0 ? 0 : histogram[length] * kWidth / most;
    table.push_back(
        {std::to_string(length), std::to_string(histogram[length]), std::string(bar, '#')});
  }
  console.print(table);
}

int inspectDataset(const InspectDatasetOptions& options, Session& session) {
  const DatasetSummary summary = describeDataset(options.path);
  Console& console = session.console;
  console.printJson({{"kind", summary.kind},
                     {"options", objectOf(summary.options)},
                     {"tasks", summary.tasks},
                     {"length",
                      {{"mean", summary.mean_length},
                       {"max", summary.max_length},
                       {"histogram", summary.length_histogram}}},
                     {"images", summary.images},
                     {"objects", objectOf(summary.objects)},
                     {"splits", objectOf(summary.splits)},
                     {"checksums_ok", summary.checksums_ok},
                     {"faults", toJson(summary.faults)}});
  console.print("dataset of " + summary.kind + " in " + options.path);
  TextTable facts;
  for (const auto& [key, value] : summary.options) facts.push_back({"  " + key, value});
  facts.push_back({"  tasks", std::to_string(summary.tasks)});
  facts.push_back({"  images", std::to_string(summary.images)});
  for (const auto& [split, count] : summary.splits) {
    facts.push_back({"  in " + split, std::to_string(count)});
  }
  for (const auto& [type, count] : summary.objects) {
    facts.push_back({"  " + type, std::to_string(count)});
  }
  facts.push_back({"  checksums", summary.checksums_ok ? "right" : "WRONG"});
  console.print(facts);
  if (summary.tasks > 0) {
    console.print("references: mean length " + decimal(summary.mean_length, 3) + ", longest " +
                  std::to_string(summary.max_length));
    printHistogram(console, summary.length_histogram);
  }
  for (const Fault& fault : summary.faults) console.error("conceptplan: " + fault.text());
  return summary.faults.empty() ? kDone : kWrongInput;
}

}  // namespace

void addInspectDatasetCommand(CommandLine& line, CLI::App& group) {
  const auto options = makeOptions<InspectDatasetOptions>();
  line.add(group, "dataset", "Figures of a dataset, and whether its files are whole",
           "conceptplan inspect dataset data/tasks",
           [options](Session& session) { return inspectDataset(*options, session); })
      .add_option("DIR", options->path, "Folder of the dataset")
      ->required();
}

}  // namespace conceptplan::cli
