#include "conceptplan/domain/simulation/simulator.hpp"

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace conceptplan {
namespace {

bool adjacent(Cell a, Cell b) { return std::abs(a.x - b.x) + std::abs(a.y - b.y) == 1; }

ObjectState& target(World& world) {
  if (world.target >= world.objects.size())
    throw std::invalid_argument("target " + std::to_string(world.target) + " of a world of " +
                                std::to_string(world.objects.size()) + " objects");
  return world.objects[world.target];
}

/// Nothing if the action was carried out, else why not; `obstacle` is set on a collision.
std::optional<Obstruction> carryOut(World& world, Action action,
                                    std::optional<std::size_t>& obstacle) {
  ObjectState& moved = target(world);
  switch (action) {
    case Action::kMoveFront:
    case Action::kMoveBack:
    case Action::kMoveLeft:
    case Action::kMoveRight: {
      const Cell next = cellAfter(moved.cell, action);
      if (!world.workbench.contains(next)) return Obstruction::kOffWorkbench;
      for (std::size_t i = 0; i < world.objects.size(); ++i) {
        if (i != world.target && world.objects[i].cell == next) {
          obstacle = i;
          return Obstruction::kCollision;
        }
      }
      moved.cell = next;
      return std::nullopt;
    }
    case Action::kRotateLeft:
      moved.rotation = (moved.rotation + 1) % 4;
      return std::nullopt;
    case Action::kRotateRight:
      moved.rotation = (moved.rotation + 3) % 4;
      return std::nullopt;
    case Action::kChangeColor:
      for (std::size_t i = 0; i < world.objects.size(); ++i) {
        const ObjectState& other = world.objects[i];
        if (i != world.target && other.type == ObjectType::kDyer &&
            adjacent(other.cell, moved.cell)) {
          moved.color = other.color;
          return std::nullopt;
        }
      }
      return Obstruction::kNoDyer;
  }
  throw std::invalid_argument("no action " + std::to_string(static_cast<int>(action)));
}

}  // namespace

std::string_view name(Obstruction obstruction) {
  constexpr std::array<std::string_view, 3> kNames{"off_workbench", "collision", "no_dyer"};
  return kNames.at(static_cast<std::size_t>(obstruction));
}

Cell cellAfter(Cell cell, Action action) {
  switch (action) {
    case Action::kMoveFront:
      return {cell.x, cell.y + 1};
    case Action::kMoveBack:
      return {cell.x, cell.y - 1};
    case Action::kMoveLeft:
      return {cell.x - 1, cell.y};
    case Action::kMoveRight:
      return {cell.x + 1, cell.y};
    default:
      return cell;
  }
}

ActionOutcome applyAction(const World& world, Action action) {
  ActionOutcome outcome{world, std::nullopt, std::nullopt};
  outcome.obstruction = carryOut(outcome.world, action, outcome.obstacle);
  return outcome;
}

std::optional<Obstruction> advance(World& world, Action action) {
  std::optional<std::size_t> obstacle;
  return carryOut(world, action, obstacle);
}

std::size_t movedObject(const World& world, std::span<const std::size_t> moved, std::size_t step) {
  return moved.empty() ? world.target : moved[step];
}

Replay replay(World world, const ActionSequence& actions, std::span<const std::size_t> moved) {
  if (!moved.empty() && moved.size() != actions.size())
    throw std::invalid_argument(std::to_string(moved.size()) + " moved objects for " +
                                std::to_string(actions.size()) + " actions");
  target(world);
  Replay result{std::move(world), 0, std::nullopt, std::nullopt};
  for (const Action action : actions) {
    result.world.target = movedObject(result.world, moved, result.steps);
    result.obstruction = carryOut(result.world, action, result.obstacle);
    if (result.obstruction) break;
    ++result.steps;
  }
  return result;
}

}  // namespace conceptplan
