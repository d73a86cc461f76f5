#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "conceptplan/domain/files/rgbd_image_file.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "symbol_keys.hpp"
#include "yaml_map.hpp"

namespace conceptplan {
namespace {

constexpr int kFormatVersion = 1;
constexpr int kMostPlans = 1000;
constexpr int kMostObjects = 255;
constexpr int kMostEvaluations = 1'000'000;
constexpr double kSumTolerance = 1e-3;
constexpr const char* kFileName = "scenario.yaml";
/// What plans for several targets where no planner is named; `belief` is for one.
constexpr const char* kPlannerOfSeveral = "astar";

bool hasInstance(const RgbdImage& image, std::uint8_t instance) {
  return std::find(image.mask.begin(), image.mask.end(), instance) != image.mask.end();
}

std::string instancesText(const RgbdImage& image) {
  std::array<bool, 256> present{};
  for (const std::uint8_t id : image.mask) present[id] = true;
  std::string text;
  for (std::size_t id = 1; id < present.size(); ++id) {
    if (present[id]) text += (text.empty() ? "" : ", ") + std::to_string(id);
  }
  return text.empty() ? "no object" : "the objects " + text;
}

/// Reads the keys of one file, collecting faults in the document.
class ScenarioReader {
 public:
  explicit ScenarioReader(const std::filesystem::path& file) : document_(loadYaml(file)) {
    scenario_.file = file;
  }

  Scenario read(const ScenarioCheck& check) {
    YamlMap root(document_, document_.root, "",
                 {"conceptplan", "name", "model", "initial", "goal", "target", "targets", "planner",
                  "refine", "render", "reference"});
    if (root.valid()) readRoot(root);
    scenario_.positions = std::move(document_.positions);
    std::vector<Fault>& faults = document_.faults;
    std::stable_sort(faults.begin(), faults.end(), [](const Fault& a, const Fault& b) {
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
    if (check && root.valid()) {
      for (Fault& fault : check(scenario_)) faults.push_back(std::move(fault));
    }
    if (!faults.empty()) throw InputError(std::move(faults));
    return std::move(scenario_);
  }

 private:
  void readRoot(YamlMap& root) {
    if (root.require("conceptplan")) root.integer("conceptplan", kFormatVersion, kFormatVersion);
    if (root.require("name")) scenario_.name = root.text("name").value_or("");
    if (const auto model = root.text("model")) scenario_.model = *model;
    if (const auto target = root.integer("target", 1, kMostObjects)) {
      scenario_.target = static_cast<std::uint8_t>(*target);
    }
    readTargets(root);
    if (const auto render = root.boolean("render")) scenario_.render = *render;
    if (const auto reference = root.text("reference")) {
      scenario_.reference = resolve(*reference);
      if (!std::filesystem::is_regular_file(*scenario_.reference)) {
        root.addFault("reference", "file not found: " + scenario_.reference->string());
      }
    }
    readPlanner(root);
    readRefine(root);
    readInput(root);
  }

  void readTargets(YamlMap& root) {
    if (!root.has("targets")) return;
    if (root.has("target")) root.addFault("target", "cannot stand beside targets");
    const YAML::Node list = *root.node("targets");
    if (!list.IsSequence() || list.size() < 2) {
      root.addFault("targets", "expected a list of at least 2 instance ids, found " +
                                   (list.IsSequence() ? "a list of " + std::to_string(list.size())
                                                      : describe(list)));
      return;
    }
    for (const YAML::Node& entry : list) {
      const std::optional<long long> id = integerOf(entry);
      if (!id || *id < 1 || *id > kMostObjects) {
        document_.addFault(entry, "targets",
                           "expected an instance id in [1, 255], found " + describe(entry));
      } else if (std::ranges::count(scenario_.targets, *id) > 0) {
        document_.addFault(entry, "targets", "instance " + std::to_string(*id) + " is given twice");
      } else {
        scenario_.targets.push_back(static_cast<std::uint8_t>(*id));
      }
    }
    scenario_.planner.name = kPlannerOfSeveral;
    if (root.has("refine")) {
      root.addFault("refine", "a plan for several targets cannot be refined to one motion");
    }
  }

  std::filesystem::path resolve(const std::string& path) const {
    return document_.path.parent_path() / path;
  }

  void readPlanner(YamlMap& root) {
    if (!root.has("planner")) return;
    YamlMap planner(document_, *root.node("planner"), "planner", {"name", "options", "top"});
    if (const auto name = planner.text("name")) scenario_.planner.name = *name;
    if (const auto top = planner.integer("top", 1, kMostPlans)) {
      scenario_.planner.top = static_cast<int>(*top);
    }
    if (!planner.has("options")) return;
    YamlMap options(document_, *planner.node("options"), "planner.options", {});
    for (const auto& [key, value] : options.values()) {
      if (const auto text = options.text(key)) scenario_.planner.options[key] = *text;
    }
  }

  void readRefine(YamlMap& root) {
    if (!root.has("refine")) return;
    YamlMap refine(document_, *root.node("refine"), "refine",
                   {"clearance_m", "algorithm", "max_evaluations"});
    RefinementChoice choice;
    if (refine.require("clearance_m")) {
      choice.clearance_m = refine.number("clearance_m", 0, 1).value_or(choice.clearance_m);
    }
    choice.algorithm = refine.text("algorithm");
    if (const auto evaluations = refine.integer("max_evaluations", 1, kMostEvaluations)) {
      choice.max_evaluations = static_cast<int>(*evaluations);
    }
    scenario_.refine = std::move(choice);
  }

  void readInput(YamlMap& root) {
    if (!root.require("initial") || !root.require("goal")) {
      if (!root.has("goal") && !root.has("initial")) root.require("goal");
      return;
    }
    YamlMap initial(document_, *root.node("initial"), "initial",
                    {"rgb", "depth", "mask", "symbols"});
    YamlMap goal(document_, *root.node("goal"), "goal", {"rgb", "depth", "mask", "symbols"});
    if (!initial.valid() || !goal.valid()) return;
    if (initial.has("symbols") != goal.has("symbols")) {
      root.addFault("goal", "initial and goal must both be given in pictures, or both in symbols");
      return;
    }
    if (initial.has("symbols")) {
      readSymbols(root, initial, goal);
    } else {
      readPictures(root, initial, goal);
    }
  }

  void readPictures(YamlMap& root, YamlMap& initial, YamlMap& goal) {
    const std::optional<RgbdImage> first = readPicture(initial);
    const std::optional<RgbdImage> last = readPicture(goal);
    const auto checkTarget = [&](const char* key, std::uint8_t target) {
      const auto checkImage = [&](const std::optional<RgbdImage>& image, const char* which) {
        if (!image || hasInstance(*image, target)) return;
        root.addFault(key, "instance " + std::to_string(target) + " is not in the " + which +
                               " mask, which shows " + instancesText(*image));
      };
      checkImage(first, "initial");
      checkImage(last, "goal");
    };
    if (scenario_.target) checkTarget("target", *scenario_.target);
    for (const std::uint8_t target : scenario_.targets) checkTarget("targets", target);
    if (first && last) scenario_.input = PictureInput{*first, *last};
  }

  std::optional<RgbdImage> readPicture(YamlMap& map) {
    RgbdPaths paths;
    bool complete = true;
    const auto readPath = [&](const char* key, std::filesystem::path& path) {
      const std::optional<std::string> text =
          map.require(key) ? map.text(key) : std::optional<std::string>();
      complete = complete && text.has_value();
      if (text) path = resolve(*text);
    };
    readPath("rgb", paths.rgb);
    readPath("depth", paths.depth);
    readPath("mask", paths.mask);
    if (!complete) return std::nullopt;
    RgbdImage image;
    try {
      image = readRgbdImage(paths);
    } catch (const InputError& error) {
      for (const Fault& fault : error.faults()) {
        map.addFault(fault.key, fault.path + ": " + fault.message);
      }
      return std::nullopt;
    }
    if (image.width != kFrameWidth || image.height != kFrameHeight) {
      map.addFault("rgb", paths.rgb.string() + ": expected a frame of 384 x 256, found " +
                              std::to_string(image.width) + " x " + std::to_string(image.height));
      return std::nullopt;
    }
    if (std::all_of(image.mask.begin(), image.mask.end(), [](auto id) { return id == 0; })) {
      map.addFault("mask", paths.mask.string() + ": no object: every pixel is 0, the background");
      return std::nullopt;
    }
    return image;
  }

  void readSymbols(YamlMap& root, YamlMap& initial, YamlMap& goal) {
    for (YamlMap* map : {&initial, &goal}) {
      for (const char* key : {"rgb", "depth", "mask"}) {
        if (map->has(key)) map->addFault(key, "a picture cannot stand beside symbols");
      }
    }
    SymbolInput input;
    readGoals(root, goal, input);
    YamlMap symbols(document_, *initial.node("symbols"), "initial.symbols", {"objects"});
    if (symbols.require("objects")) {
      const YAML::Node list = *symbols.node("objects");
      if (!list.IsSequence() || list.size() == 0 || list.size() > kMostObjects) {
        symbols.addFault(
            "objects",
            "expected a list of 1 to 255 objects, found " +
                (list.IsSequence() ? "a list of " + std::to_string(list.size()) : describe(list)));
      } else {
        for (std::size_t i = 0; i < list.size(); ++i) {
          input.objects.push_back(readObject(list[i], objectKey(i)));
        }
        checkSymbolicTarget(root, list.size());
      }
    }
    scenario_.input = std::move(input);
  }

  /// One goal, or one for each of several targets.
  void readGoals(YamlMap& root, YamlMap& goal, SymbolInput& input) {
    const YAML::Node symbols = *goal.node("symbols");
    if (!root.has("targets")) {
      input.goal = readObject(symbols, kGoalSymbolsKey);
      return;
    }
    const std::size_t targets = root.node("targets")->size();
    if (targets < 2) return;  // told of already
    if (!symbols.IsSequence() || symbols.size() != targets) {
      goal.addFault("symbols",
                    "expected a list with what each of the " + std::to_string(targets) +
                        " targets should become, found " +
                        (symbols.IsSequence() ? "a list of " + std::to_string(symbols.size())
                                              : describe(symbols)));
      return;
    }
    for (std::size_t i = 0; i < targets; ++i) {
      input.goals.push_back(readObject(symbols[i], goalKey(i)));
    }
  }

  void checkSymbolicTarget(YamlMap& root, std::size_t objects) {
    for (const std::uint8_t target : scenario_.targets) {
      if (target <= objects) continue;
      root.addFault("targets", "expected objects in [1, " + std::to_string(objects) + "], found " +
                                   std::to_string(target));
    }
    if (root.has("targets")) return;
    if (!root.has("target") && objects > 1) {
      root.addFault("target", "the key is missing: with symbols and " + std::to_string(objects) +
                                  " objects it says which one the goal is about");
    } else if (scenario_.target.value_or(1) > objects) {
      root.addFault("target", "expected an object in [1, " + std::to_string(objects) + "], found " +
                                  std::to_string(*scenario_.target));
    }
  }

  GivenSymbols readObject(const YAML::Node& node, const std::string& key) {
    GivenSymbols given;
    YamlMap object(document_, node, key,
                   {"type", "position_x", "position_y", "rotation", "color", "size"});
    for (const Concept which : kConcepts) {
      const std::string concept_key = symbolKey(which);
      if (object.require(concept_key)) {
        given[index(which)] = readSymbol(object, concept_key);
      }
    }
    return given;
  }

  GivenSymbol readSymbol(YamlMap& object, const std::string& key) {
    static constexpr const char* kExpected =
        "expected a symbol's number, or a list of probabilities that sum to 1; found ";
    const YAML::Node node = *object.node(key);
    if (const std::optional<long long> symbol = integerOf(node);
        symbol && *symbol >= 0 && *symbol <= 0xffff) {
      return SymbolId{static_cast<std::int32_t>(*symbol)};
    }
    if (!node.IsSequence()) {
      object.addFault(key, kExpected + describe(node));
      return SymbolId{0};
    }
    std::vector<double> distribution;
    for (const YAML::Node& entry : node) {
      const std::optional<double> probability = numberOf(entry);
      if (!probability || *probability < 0 || *probability > 1) {
        object.addFault(key, kExpected + describe(entry) + " in the list");
        return SymbolId{0};
      }
      distribution.push_back(*probability);
    }
    const double sum = std::accumulate(distribution.begin(), distribution.end(), 0.0);
    if (std::abs(sum - 1) > kSumTolerance) {
      object.addFault(key, kExpected + std::string("the sum ") + std::to_string(sum));
      return SymbolId{0};
    }
    for (double& probability : distribution) probability /= sum;
    return distribution;
  }

  YamlDocument document_;
  Scenario scenario_;
};

}  // namespace

Scenario readScenario(const std::filesystem::path& path, const ScenarioCheck& check) {
  const bool folder = std::filesystem::is_directory(path);
  return ScenarioReader(folder ? path / kFileName : path).read(check);
}

std::vector<std::filesystem::path> findScenarios(const std::filesystem::path& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::exists(path, error)) {
    throw InputError({Fault{path.string(), {}, {}, "", "no such file or folder"}});
  }
  if (!fs::is_directory(path)) return {path};
  if (fs::exists(path / kFileName)) return {path / kFileName};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, error)) {
    if (fs::exists(entry.path() / kFileName)) files.push_back(entry.path() / kFileName);
  }
  if (files.empty()) {
    throw InputError(
        {Fault{path.string(), {}, {}, "", "no scenario.yaml in the folder or in its sub-folders"}});
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace conceptplan
