#include "conceptplan/domain/simulation/task_generator.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "conceptplan/domain/simulation/random_stream.hpp"
#include "conceptplan/domain/simulation/reference_planner.hpp"

namespace conceptplan {
namespace {

constexpr int kNumObstacles = 2;
constexpr std::array<ObjectType, 7> kSeenTypes{
    ObjectType::kBread, ObjectType::kCup,    ObjectType::kEgg, ObjectType::kLettuce,
    ObjectType::kPlate, ObjectType::kTomato, ObjectType::kPot};
constexpr std::array<ObjectType, 4> kUnseenTypes{ObjectType::kCellphone, ObjectType::kDishSponge,
                                                 ObjectType::kSaltshaker, ObjectType::kPotato};

/// A hash of what an object is; the type in the lowest bits, so that fields never overlap.
std::uint64_t code(const ObjectState& object) {
  std::uint64_t code = 0;
  for (const int part : {object.cell.x, object.cell.y, object.rotation, object.color, object.size,
                         static_cast<int>(object.type)})
    code = code << 8 | static_cast<std::uint8_t>(part);
  return code;
}

ObjectState drawObject(ObjectSet objects, Cell cell, RandomStream& random) {
  ObjectState object;
  object.type = objects == ObjectSet::kSeen ? kSeenTypes[random.below(kSeenTypes.size())]
                                            : kUnseenTypes[random.below(kUnseenTypes.size())];
  object.cell = cell;
  object.rotation = random.between(0, 3);
  object.color = random.between(0, 5);
  object.size = random.between(0, 3);
  return object;
}

/// `count` different cells in random order.
std::vector<Cell> drawCells(const Workbench& workbench, std::size_t count, RandomStream& random) {
  std::vector<Cell> cells;
  for (int y = 0; y < workbench.rows; ++y)
    for (int x = 0; x < workbench.columns; ++x) cells.push_back({x, y});
  for (std::size_t i = 0; i < count; ++i)
    std::swap(cells[i], cells[i + random.below(cells.size() - i)]);
  cells.resize(count);
  return cells;
}

struct Arrangement {
  World initial;
  ObjectState goal;
};

Arrangement drawArrangement(const TaskOptions& options, RandomStream& random) {
  Arrangement drawn;
  const std::vector<Cell> cells = drawCells(drawn.initial.workbench, 3 + kNumObstacles, random);
  ObjectState target = drawObject(options.objects, cells[0], random);
  std::vector<ObjectState> others;
  if (options.level >= 2)
    for (std::size_t i = 0; i < kNumObstacles; ++i)
      others.push_back(drawObject(options.objects, cells[2 + i], random));
  drawn.goal = target;
  drawn.goal.cell = cells[1];
  if (options.level >= 3) {
    ObjectState dyer = drawObject(options.objects, cells.back(), random);
    dyer.type = ObjectType::kDyer;
    if (random.below(4) < 3) {
      dyer.color = (target.color + random.between(1, 5)) % 6;
      drawn.goal.color = dyer.color;
    }
    others.push_back(dyer);
  }
  if (options.level >= 4) drawn.goal.rotation = random.between(0, 3);

  // The target stands at a random place in the list, so that nothing can be read off the order.
  drawn.initial.target = random.below(others.size() + 1);
  others.insert(others.begin() + static_cast<std::ptrdiff_t>(drawn.initial.target), target);
  drawn.initial.objects = std::move(others);
  return drawn;
}

std::string taskId(int level, int i) {
  std::array<char, 32> id{};
  std::snprintf(id.data(), id.size(), "level%d-%06d", level, i);
  return id.data();
}

}  // namespace

TaskGenerator::TaskGenerator(const TaskOptions& options) : options_(options) {
  if (options.level < 1 || options.level > 4)
    throw std::invalid_argument("level must be in [1, 4], not " + std::to_string(options.level));
  if (options.combination == Combination::kUnseenTask && options.split != Split::kTrain &&
      options.level > 2)
    throw std::invalid_argument(
        "unseen-task combinations of the " + std::string(name(options.split)) +
        " split exist at levels 1 and 2 only, not at level " + std::to_string(options.level));
}

Task TaskGenerator::task(int i) const {
  if (i < 0) throw std::invalid_argument("task " + std::to_string(i) + " is below 0");
  const auto split = static_cast<std::uint64_t>(options_.split);
  RandomStream random{options_.seed,
                      split,
                      static_cast<std::uint64_t>(options_.level),
                      static_cast<std::uint64_t>(options_.objects),
                      static_cast<std::uint64_t>(options_.combination),
                      static_cast<std::uint64_t>(i)};
  for (;;) {
    Arrangement drawn = drawArrangement(options_, random);
    if (splitOf(drawn.initial, drawn.goal) != options_.split) continue;
    std::optional<ActionSequence> plan = shortestPlan(drawn.initial, drawn.goal, random);
    if (!plan) continue;
    if (options_.combination == Combination::kUnseenTask &&
        isHeldOut(*plan) != (options_.split != Split::kTrain))
      continue;
    // The split in the two highest bits keeps the seeds of splits apart.
    const std::uint64_t hash =
        stableHash({options_.seed, split, random.below(1u << 31), random.below(1u << 31)});
    return {taskId(options_.level, i), options_.level,
            std::move(drawn.initial),  drawn.goal,
            std::move(*plan),          hash >> 2 | (split + 1) << 62};
  }
}

Split splitOf(const World& initial, const ObjectState& goal) {
  std::uint64_t hash = stableHash({static_cast<std::uint64_t>(initial.workbench.columns),
                                   static_cast<std::uint64_t>(initial.workbench.rows),
                                   code(initial.objects.at(initial.target)), code(goal)});
  // The order of the other objects says nothing about the arrangement.
  std::vector<std::uint64_t> others;
  for (std::size_t i = 0; i < initial.objects.size(); ++i)
    if (i != initial.target) others.push_back(code(initial.objects[i]));
  std::sort(others.begin(), others.end());
  for (const std::uint64_t other : others) hash = stableHash({hash, other});
  const std::uint64_t tenth = hash % 10;
  return tenth < 8 ? Split::kTrain : tenth == 8 ? Split::kValidation : Split::kTest;
}

bool isHeldOut(const ActionSequence& plan) {
  const auto has = [&plan](Action action) {
    return std::find(plan.begin(), plan.end(), action) != plan.end();
  };
  return (has(Action::kMoveFront) && has(Action::kMoveRight)) ||
         (has(Action::kMoveBack) && has(Action::kMoveLeft));
}

}  // namespace conceptplan
