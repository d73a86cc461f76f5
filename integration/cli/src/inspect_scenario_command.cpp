#include <array>

#include "commands.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "exit_code.hpp"

namespace conceptplan::cli {
namespace {

struct InspectScenarioOptions {
  std::string path;
};

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

std::string targetText(const Scenario& scenario) {
  if (scenario.target) return "instance " + std::to_string(*scenario.target);
  if (scenario.targets.empty()) return "the object whose symbols differ";
  std::string text;
  for (const std::uint8_t target : scenario.targets) {
    text += (text.empty() ? "instances " : ", ") + std::to_string(target);
  }
  return text;
}

int inspectScenario(const InspectScenarioOptions& options, Session& session) {
  const Scenario scenario = readScenario(options.path);
  Json document{{"name", scenario.name},
                {"model", scenario.model},
                {"target", scenario.target ? Json(*scenario.target) : Json()},
                {"targets", scenario.targets},
                {"planner",
                 {{"name", scenario.planner.name},
                  {"options", scenario.planner.options},
                  {"top", scenario.planner.top}}},
                {"render", scenario.render}};
  TextTable facts{
      {"name", scenario.name},
      {"model", scenario.model},
      {"target", targetText(scenario)},
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
    const Task& task = reference.task;
    for (std::size_t step = 0; step < task.reference.size(); ++step) {
      const std::string action(name(task.reference[step]));
      plan.push_back(action);
      if (!text.empty()) text += ", ";
      if (!task.moved.empty()) text += std::to_string(task.moved[step] + 1) + ":";
      text += action;
    }
    document["reference"] = {{"level", task.level}, {"plan", plan}};
    if (!task.moved.empty()) {
      document["reference"]["moved"] = Json::array();
      for (const std::size_t moved : task.moved)
        document["reference"]["moved"].push_back(moved + 1);
    }
    facts.push_back({"reference", "level " + std::to_string(reference.task.level) + ": " +
                                      (text.empty() ? "no plan" : text)});
  }
  session.console.printJson(document);
  session.console.print(facts);
  return kDone;
}

}  // namespace

void addInspectScenarioCommand(CommandLine& line, CLI::App& group) {
  const auto options = makeOptions<InspectScenarioOptions>();
  line.add(group, "scenario", "What a scenario asks for",
           "conceptplan inspect scenario scenarios/level3-0001",
           [options](Session& session) { return inspectScenario(*options, session); })
      .add_option("SCENARIO", options->path, "Scenario file or folder")
      ->required();
}

}  // namespace conceptplan::cli
