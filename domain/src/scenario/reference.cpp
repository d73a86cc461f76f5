#include "conceptplan/domain/scenario/reference.hpp"

#include <charconv>
#include <limits>
#include <set>
#include <vector>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/nearest_name.hpp"
#include "conceptplan/domain/simulation/judgement.hpp"
#include "yaml_map.hpp"

namespace conceptplan {
namespace {

constexpr int kFormatVersion = 1;
constexpr int kNumColors = 6;
constexpr int kMostCells = 1000;
constexpr int kMostObjects = 255;

std::vector<std::string_view> typeNames() {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < kNumObjectTypes; ++i) names.push_back(name(ObjectType(i)));
  return names;
}

std::vector<std::string_view> colorNames() {
  std::vector<std::string_view> names;
  for (int i = 0; i < kNumColors; ++i) names.push_back(colorName(i));
  return names;
}

class ReferenceReader {
 public:
  explicit ReferenceReader(const std::filesystem::path& path) : document_(loadYaml(path)) {}

  Reference read() {
    YamlMap root(document_, document_.root, "",
                 {"conceptplan", "id", "level", "domain", "appearance", "workbench", "objects",
                  "target", "goal", "targets", "goals", "plan", "moved"});
    if (root.valid()) readRoot(root);
    if (!document_.faults.empty()) throw InputError(std::move(document_.faults));
    return std::move(reference_);
  }

 private:
  void readRoot(YamlMap& root) {
    Task& task = reference_.task;
    for (const char* key :
         {"conceptplan", "id", "level", "appearance", "workbench", "objects", "plan"}) {
      root.require(key);
    }
    root.integer("conceptplan", kFormatVersion, kFormatVersion);
    task.id = root.text("id").value_or("");
    task.level = static_cast<int>(root.integer("level", 1, 4).value_or(1));
    readDomain(root);
    readAppearance(root);
    readWorkbench(root);
    readObjects(root);
    if (root.has("targets")) {
      readTargets(root);
    } else {
      readTarget(root);
    }
    readPlan(root);
  }

  void readTarget(YamlMap& root) {
    Task& task = reference_.task;
    for (const char* key : {"goals", "moved"}) {
      if (root.has(key)) root.addFault(key, "is for several targets");
    }
    const int count = static_cast<int>(task.initial.objects.size());
    if (root.require("target") && count > 0) {
      task.initial.target =
          static_cast<std::size_t>(root.integer("target", 1, count).value_or(1) - 1);
    }
    if (root.require("goal")) task.goal = readObject(*root.node("goal"), "goal");
  }

  /// Several targets, their goals, and which of them each action of the plan moves.
  void readTargets(YamlMap& root) {
    Task& task = reference_.task;
    for (const char* key : {"target", "goal"}) {
      if (root.has(key)) root.addFault(key, "is for one target");
    }
    const std::vector<std::size_t> targets = readObjectIds(root, "targets");
    task.moved = readObjectIds(root, "moved");
    const std::optional<YAML::Node> goals = root.node("goals");
    if (targets.empty() || !goals || !goals->IsSequence() || goals->size() != targets.size()) {
      root.addFault("goals", "expected a list of a goal for each of `targets`, at least one");
      return;
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
      const ObjectState goal = readObject((*goals)[i], "goals[" + std::to_string(i) + "]");
      if (i == 0) {
        task.initial.target = targets[0];
        task.goal = goal;
      } else {
        task.further.push_back({targets[i], goal});
      }
    }
  }

  /// Instance ids as positions in the list of objects.
  std::vector<std::size_t> readObjectIds(YamlMap& root, const char* key) {
    std::vector<std::size_t> objects;
    if (!root.require(key)) return objects;
    const YAML::Node list = *root.node(key);
    const std::size_t count = reference_.task.initial.objects.size();
    if (!list.IsSequence())
      root.addFault(key, "expected a list of objects, found " + describe(list));
    for (const YAML::Node& entry : list) {
      const std::optional<long long> id = integerOf(entry);
      if (id && *id >= 1 && static_cast<std::size_t>(*id) <= count) {
        objects.push_back(static_cast<std::size_t>(*id) - 1);
      } else {
        document_.addFault(
            entry, key,
            "expected an object in [1, " + std::to_string(count) + "], found " + describe(entry));
      }
    }
    return objects;
  }

  void readDomain(YamlMap& root) {
    const std::optional<std::string> text = root.text("domain");
    if (!text) return;
    if (const auto domain = renderDomainNamed(*text)) {
      reference_.domain = *domain;
    } else {
      root.addFault("domain", "expected standard or shifted, found \"" + *text + "\"");
    }
  }

  void readAppearance(YamlMap& root) {
    const std::optional<std::string> text = root.text("appearance");
    if (!text) return;
    const char* const end = text->data() + text->size();
    const auto [stop, error] = std::from_chars(text->data(), end, reference_.task.appearance);
    if (error != std::errc{} || stop != end) {
      root.addFault("appearance",
                    "expected a seed, a whole number below 2^64, found \"" + *text + "\"");
    }
  }

  void readWorkbench(YamlMap& root) {
    if (!root.has("workbench")) return;
    YamlMap map(document_, *root.node("workbench"), "workbench", {"columns", "rows", "cell_m"});
    Workbench& workbench = reference_.task.initial.workbench;
    map.require("columns");
    map.require("rows");
    map.require("cell_m");
    workbench.columns = static_cast<int>(map.integer("columns", 1, kMostCells).value_or(3));
    workbench.rows = static_cast<int>(map.integer("rows", 1, kMostCells).value_or(5));
    workbench.cell_m = map.number("cell_m", 0.001, 10).value_or(0.2);
  }

  void readObjects(YamlMap& root) {
    const std::optional<YAML::Node> list = root.node("objects");
    if (!list) return;
    if (!list->IsSequence() || list->size() == 0 || list->size() > kMostObjects) {
      root.addFault("objects", "expected a list of 1 to 255 objects");
      return;
    }
    World& world = reference_.task.initial;
    std::set<Cell> taken;
    for (std::size_t i = 0; i < list->size(); ++i) {
      const std::string key = "objects[" + std::to_string(i) + "]";
      world.objects.push_back(readObject((*list)[i], key));
      if (!taken.insert(world.objects.back().cell).second) {
        document_.addFault((*list)[i], key + ".cell", "another object stands in that cell");
      }
    }
  }

  ObjectState readObject(const YAML::Node& node, const std::string& key) {
    ObjectState object;
    YamlMap map(document_, node, key, {"type", "cell", "rotation", "color", "size"});
    for (const char* part : {"type", "cell", "rotation", "color", "size"}) map.require(part);
    if (const auto text = map.text("type")) {
      if (const auto type = objectTypeNamed(*text)) {
        object.type = *type;
      } else {
        map.addFault("type", "unknown type \"" + *text + "\"" + didYouMean(*text, typeNames()));
      }
    }
    if (const auto text = map.text("color")) {
      const std::vector<std::string_view> names = colorNames();
      const auto found = std::find(names.begin(), names.end(), *text);
      object.color = static_cast<int>(found - names.begin());
      if (found == names.end()) {
        map.addFault("color", "unknown colour \"" + *text + "\"" + didYouMean(*text, names));
      }
    }
    object.rotation = static_cast<int>(map.integer("rotation", 0, 3).value_or(0));
    object.size = static_cast<int>(map.integer("size", 0, 3).value_or(0));
    readCell(map, object.cell);
    return object;
  }

  void readCell(YamlMap& map, Cell& cell) {
    const std::optional<YAML::Node> node = map.node("cell");
    if (!node) return;
    if (node->IsSequence() && node->size() == 2) {
      const std::optional<long long> x = integerOf((*node)[0]);
      const std::optional<long long> y = integerOf((*node)[1]);
      if (x && y && *x >= 0 && *x < kMostCells && *y >= 0 && *y < kMostCells) {
        cell = {static_cast<int>(*x), static_cast<int>(*y)};
        if (reference_.task.initial.workbench.contains(cell)) return;
      }
    }
    map.addFault("cell", "expected [column, row] on the workbench");
  }

  void readPlan(YamlMap& root) {
    const std::optional<YAML::Node> list = root.node("plan");
    if (!list) return;
    if (!list->IsSequence()) {
      root.addFault("plan", "expected a list of actions, found " + describe(*list));
      return;
    }
    for (const YAML::Node& entry : *list) {
      const std::string text = entry.IsScalar() ? entry.Scalar() : describe(entry);
      if (const auto action = actionNamed(text)) {
        reference_.task.reference.push_back(*action);
      } else {
        document_.addFault(entry, "plan",
                           "unknown action \"" + text + "\"" + didYouMean(text, actionNames()));
      }
    }
    const Task& task = reference_.task;
    if (root.has("targets") && root.has("moved") && task.moved.size() != list->size()) {
      root.addFault("moved", "expected an object for each of " + std::to_string(list->size()) +
                                 " actions, found " + std::to_string(task.moved.size()));
    }
  }

  YamlDocument document_;
  Reference reference_;
};

void emitObject(YAML::Emitter& out, const ObjectState& object) {
  out << YAML::Flow << YAML::BeginMap << YAML::Key << "type" << YAML::Value
      << std::string(name(object.type)) << YAML::Key << "cell" << YAML::Value << YAML::Flow
      << YAML::BeginSeq << object.cell.x << object.cell.y << YAML::EndSeq << YAML::Key << "rotation"
      << YAML::Value << object.rotation << YAML::Key << "color" << YAML::Value
      << std::string(colorName(object.color)) << YAML::Key << "size" << YAML::Value << object.size
      << YAML::EndMap;
}

void emitTargets(YAML::Emitter& out, const Task& task) {
  const std::vector<FurtherTarget> targets = targetsOf(task);
  out << YAML::Key << "targets" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const FurtherTarget& target : targets) out << target.object + 1;
  out << YAML::EndSeq;
  out << YAML::Key << "goals" << YAML::Value << YAML::BeginSeq;
  for (const FurtherTarget& target : targets) emitObject(out, target.goal);
  out << YAML::EndSeq;
  out << YAML::Key << "moved" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const std::size_t moved : task.moved) out << moved + 1;
  out << YAML::EndSeq;
}

}  // namespace

bool hasSolution(const Reference& reference) {
  const Task& task = reference.task;
  return !task.reference.empty() || judge(task, ActionSequence{}).succeeded();
}

Reference readReference(const std::filesystem::path& path) { return ReferenceReader(path).read(); }

void writeReference(const std::filesystem::path& path, const Reference& reference) {
  const Task& task = reference.task;
  const Workbench& workbench = task.initial.workbench;
  YAML::Emitter out;
  out.SetDoublePrecision(12);
  out << YAML::BeginMap << YAML::Key << "conceptplan" << YAML::Value << kFormatVersion;
  out << YAML::Key << "id" << YAML::Value << task.id;
  out << YAML::Key << "level" << YAML::Value << task.level;
  out << YAML::Key << "domain" << YAML::Value << std::string(name(reference.domain));
  out << YAML::Key << "appearance" << YAML::Value << std::to_string(task.appearance);
  out << YAML::Key << "workbench" << YAML::Value << YAML::Flow << YAML::BeginMap << YAML::Key
      << "columns" << YAML::Value << workbench.columns << YAML::Key << "rows" << YAML::Value
      << workbench.rows << YAML::Key << "cell_m" << YAML::Value << workbench.cell_m << YAML::EndMap;
  out << YAML::Key << "objects" << YAML::Value << YAML::BeginSeq;
  for (const ObjectState& object : task.initial.objects) emitObject(out, object);
  out << YAML::EndSeq;
  if (task.further.empty()) {
    out << YAML::Key << "target" << YAML::Value << task.initial.target + 1;
    out << YAML::Key << "goal" << YAML::Value;
    emitObject(out, task.goal);
  } else {
    emitTargets(out, task);
  }
  out << YAML::Key << "plan" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const Action action : task.reference) out << std::string(name(action));
  out << YAML::EndSeq << YAML::EndMap;
  writeFileAtomically(path, std::string(out.c_str()) + "\n");
}

}  // namespace conceptplan
