#include "dataset/task_record.hpp"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>

#include "conceptplan/domain/files/json_depth.hpp"
#include "dataset/json_fields.hpp"

namespace conceptplan {
namespace {

constexpr int kMostCells = 1000;
constexpr int kNumColors = 6;

nlohmann::ordered_json objectRecord(const ObjectState& object) {
  nlohmann::ordered_json record;
  record["type"] = name(object.type);
  record["x"] = object.cell.x;
  record["y"] = object.cell.y;
  record["rotation"] = object.rotation;
  record["color"] = colorName(object.color);
  record["size"] = object.size;
  return record;
}

std::optional<int> colorNamed(std::string_view name) {
  for (int color = 0; color < kNumColors; ++color)
    if (colorName(color) == name) return color;
  return std::nullopt;
}

ObjectState parseObject(const nlohmann::json& record, const Workbench& workbench,
                        const std::string& key, const Fault& origin, std::vector<Fault>& faults) {
  JsonFields fields(record, origin, faults, key + '.');
  ObjectState object;
  object.type = fields.choice("type", objectTypeNamed);
  object.cell.x = fields.integer("x", 0, workbench.columns - 1);
  object.cell.y = fields.integer("y", 0, workbench.rows - 1);
  object.rotation = fields.integer("rotation", 0, 3);
  object.color = fields.choice("color", colorNamed);
  object.size = fields.integer("size", 0, 3);
  fields.rejectOthers();
  return object;
}

}  // namespace

std::string taskRecord(const Task& task) {
  nlohmann::ordered_json record;
  record["id"] = task.id;
  record["level"] = task.level;
  const Workbench& workbench = task.initial.workbench;
  record["workbench"]["columns"] = workbench.columns;
  record["workbench"]["rows"] = workbench.rows;
  record["workbench"]["cell_m"] = workbench.cell_m;
  record["target"] = task.initial.target;
  record["objects"] = nlohmann::json::array();
  for (const ObjectState& object : task.initial.objects)
    record["objects"].push_back(objectRecord(object));
  record["goal"] = objectRecord(task.goal);
  record["reference"] = nlohmann::json::array();
  for (const Action action : task.reference) record["reference"].push_back(name(action));
  record["appearance"] = task.appearance;
  return record.dump();
}

Task parseTaskRecord(const std::string& line, const Fault& origin, std::vector<Fault>& faults) {
  const nlohmann::json record = nestsTooDeep(line)
                                    ? nlohmann::json(nlohmann::json::value_t::discarded)
                                    : nlohmann::json::parse(line, nullptr, false);
  Task task;
  if (record.is_discarded()) {
    faults.push_back(origin);
    faults.back().message = "is not valid JSON";
    return task;
  }
  JsonFields fields(record, origin, faults);
  task.id = fields.text("id");
  task.level = fields.integer("level", 1, 4);
  JsonFields workbench(fields.at("workbench"), origin, faults, "workbench.");
  task.initial.workbench.columns = workbench.integer("columns", 1, kMostCells);
  task.initial.workbench.rows = workbench.integer("rows", 1, kMostCells);
  task.initial.workbench.cell_m = workbench.positive("cell_m");
  workbench.rejectOthers();
  const nlohmann::json& objects = fields.at("objects");
  if (!objects.is_array() || objects.empty()) fields.fault("objects", "expected a list of objects");
  for (const nlohmann::json& object : objects)
    task.initial.objects.push_back(parseObject(
        object, task.initial.workbench,
        "objects[" + std::to_string(task.initial.objects.size()) + ']', origin, faults));
  task.initial.target = fields.unsignedInteger("target");
  if (task.initial.target >= task.initial.objects.size())
    fields.fault("target", "is not the number of an object");
  task.goal = parseObject(fields.at("goal"), task.initial.workbench, "goal", origin, faults);
  const nlohmann::json& reference = fields.at("reference");
  if (!reference.is_array()) fields.fault("reference", "expected a list of actions");
  for (const nlohmann::json& action : reference) {
    const std::optional<Action> found =
        action.is_string() ? actionNamed(action.get<std::string>()) : std::nullopt;
    if (!found) fields.fault("reference", "there is no action " + action.dump());
    task.reference.push_back(found.value_or(Action::kMoveFront));
  }
  task.appearance = fields.unsignedInteger("appearance");
  fields.rejectOthers();
  return task;
}

}  // namespace conceptplan
