#include "dataset/task_record.hpp"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "conceptplan/domain/files/json_depth.hpp"
#include "conceptplan/domain/simulation/simulator.hpp"
#include "dataset/json_fields.hpp"

namespace conceptplan {
namespace {

constexpr int kNumColors = 6;
constexpr std::size_t kMostObjects = 255;  // their instance ids, from 1 on, fit a byte

nlohmann::ordered_json workbenchRecord(const Workbench& workbench) {
  return {{"columns", workbench.columns}, {"rows", workbench.rows}, {"cell_m", workbench.cell_m}};
}

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

/// A fault for every object in the cell of an earlier one.
void checkCells(const World& world, JsonFields& fields) {
  std::set<Cell> taken;
  for (std::size_t i = 0; i < world.objects.size(); ++i)
    if (!taken.insert(world.objects[i].cell).second)
      fields.fault("objects[" + std::to_string(i) + ']', "is in the cell of another object");
}

/// A fault if the reference is illegal or does not end at the goal.
void checkReference(const Task& task, JsonFields& fields) {
  const Replay end = replay(task.initial, task.reference);
  if (!end.succeeded()) {
    fields.fault("reference", "action " + std::to_string(end.steps + 1) + ", " +
                                  std::string(name(task.reference[end.steps])) +
                                  ", is illegal: " + std::string(name(*end.obstruction)));
  } else if (end.world.objects[task.initial.target] != task.goal) {
    fields.fault("reference", "does not end at the goal");
  }
}

}  // namespace

std::string taskRecord(const Task& task) {
  nlohmann::ordered_json record;
  record["id"] = task.id;
  record["level"] = task.level;
  record["workbench"] = workbenchRecord(task.initial.workbench);
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
  const std::size_t earlier_faults = faults.size();
  JsonFields fields(record, origin, faults);
  task.id = fields.text("id");
  task.level = fields.integer("level", 1, 4);
  const nlohmann::json& workbench = fields.at("workbench");
  const nlohmann::json standard = workbenchRecord(task.initial.workbench);
  if (!workbench.is_null() && workbench != standard)
    fields.fault("workbench", "expected " + standard.dump() + ", found " + workbench.dump());
  const nlohmann::json& objects = fields.at("objects");
  if (!objects.is_array() || objects.empty() || objects.size() > kMostObjects)
    fields.fault("objects", "expected a list of 1 to " + std::to_string(kMostObjects) + " objects");
  for (const nlohmann::json& object : objects)
    task.initial.objects.push_back(parseObject(
        object, task.initial.workbench,
        "objects[" + std::to_string(task.initial.objects.size()) + ']', origin, faults));
  task.initial.target = fields.unsignedInteger("target");
  if (task.initial.target >= task.initial.objects.size())
    fields.fault("target", "is not the number of an object");
  task.goal = parseObject(fields.at("goal"), task.initial.workbench, "goal", origin, faults);
  const nlohmann::json& reference = fields.at("reference");
  if (!reference.is_array() || reference.empty())
    fields.fault("reference", "expected a list of actions");
  for (const nlohmann::json& action : reference) {
    const std::optional<Action> found =
        action.is_string() ? actionNamed(action.get<std::string>()) : std::nullopt;
    if (!found) fields.fault("reference", "there is no action " + action.dump());
    task.reference.push_back(found.value_or(Action::kMoveFront));
  }
  task.appearance = fields.unsignedInteger("appearance");
  fields.rejectOthers();
  if (faults.size() > earlier_faults) return task;
  checkCells(task.initial, fields);
  checkReference(task, fields);
  return task;
}

}  // namespace conceptplan
