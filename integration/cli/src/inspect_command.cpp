#include <algorithm>
#include <array>

#include "commands.hpp"
#include "conceptplan/domain/dataset/dataset_summary.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "exit_code.hpp"

namespace conceptplan::cli {
namespace {

struct InspectOptions {
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

int inspectDataset(const InspectOptions& options, Session& session) {
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

/// Instance ids of a mask with their numbers of pixels.
std::vector<std::pair<int, std::size_t>> instances(const RgbdImage& image) {
  std::array<std::size_t, 256> pixels{};
  for (const std::uint8_t id : image.mask) ++pixels[id];
  std::vector<std::pair<int, std::size_t>> found;
  for (int id = 1; id < 256; ++id) {
    if (pixels[static_cast<std::size_t>(id)] > 0) {
      found.emplace_back(id, pixels[static_cast<std::size_t>(id)]);
    }
  }
  return found;
}

Json pictureJson(const RgbdImage& image) {
  Json list = Json::array();
  for (const auto& [id, pixels] : instances(image)) {
    list.push_back({{"instance", id}, {"pixels", pixels}});
  }
  return {{"width", image.width}, {"height", image.height}, {"instances", list}};
}

std::string pictureText(const RgbdImage& image) {
  std::string text = std::to_string(image.width) + " x " + std::to_string(image.height);
  for (const auto& [id, pixels] : instances(image)) {
    text += ", instance " + std::to_string(id) + ": " + std::to_string(pixels) + " pixels";
  }
  return text;
}

int inspectScenario(const InspectOptions& options, Session& session) {
  const Scenario scenario = readScenario(options.path);
  Json document{{"name", scenario.name},
                {"model", scenario.model},
                {"target", scenario.target ? Json(*scenario.target) : Json()},
                {"planner",
                 {{"name", scenario.planner.name},
                  {"options", objectOf(scenario.planner.options)},
                  {"top", scenario.planner.top}}},
                {"render", scenario.render}};
  TextTable facts{
      {"name", scenario.name},
      {"model", scenario.model},
      {"target", scenario.target ? "instance " + std::to_string(*scenario.target)
                                 : "the object whose symbols differ"},
      {"planner", scenario.planner.name + ", " + std::to_string(scenario.planner.top) + " plans"}};
  if (const auto* pictures = std::get_if<PictureInput>(&scenario.input)) {
    document["initial"] = pictureJson(pictures->initial);
    document["goal"] = pictureJson(pictures->goal);
    facts.push_back({"initial", pictureText(pictures->initial)});
    facts.push_back({"goal", pictureText(pictures->goal)});
  } else {
    const std::size_t objects = std::get<SymbolInput>(scenario.input).objects.size();
    document["initial"] = {{"symbols", objects}};
    facts.push_back({"initial", "symbols of " + std::to_string(objects) + " objects"});
  }
  if (scenario.reference) {
    const Reference reference = readReference(*scenario.reference);
    Json plan = Json::array();
    std::string text;
    for (const Action action : reference.task.reference) {
      plan.push_back(name(action));
      text += (text.empty() ? "" : ", ") + std::string(name(action));
    }
    document["reference"] = {{"level", reference.task.level}, {"plan", plan}};
    facts.push_back({"reference", "level " + std::to_string(reference.task.level) + ": " +
                                      (text.empty() ? "no plan" : text)});
  }
  session.console.printJson(document);
  session.console.print(facts);
  return kDone;
}

}  // namespace

void addInspectCommands(CommandLine& line) {
  CLI::App& group = line.addGroup("inspect", "Show what is inside a model, dataset or scenario");
  const auto options = makeOptions<InspectOptions>();
  line.add(group, "dataset", "Figures of a dataset, and whether its files are whole",
           "conceptplan inspect dataset data/tasks",
           [options](Session& session) { return inspectDataset(*options, session); })
      .add_option("DIR", options->path, "Folder of the dataset")
      ->required();
  line.add(group, "scenario", "What a scenario asks for",
           "conceptplan inspect scenario scenarios/level3-0001",
           [options](Session& session) { return inspectScenario(*options, session); })
      .add_option("SCENARIO", options->path, "Scenario file or folder")
      ->required();
}

}  // namespace conceptplan::cli
