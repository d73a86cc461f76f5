#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/world.hpp"

namespace conceptplan {

/// Why an action is illegal.
enum class Obstruction { kOffWorkbench, kCollision, kNoDyer };

/// "off_workbench", "collision" or "no_dyer".
std::string_view name(Obstruction obstruction);

/// What an action did to a world.
struct ActionOutcome {
  World world;                             ///< after the action; unchanged if it is illegal
  std::optional<Obstruction> obstruction;  ///< nothing if the action is legal
  std::optional<std::size_t> obstacle;     ///< the object that was run into

  bool succeeded() const { return !obstruction; }
};

/// The ground-truth dynamics, used to make tasks and to judge plans, never to make plans.
///
/// A move takes the target one cell along: front +y, back -y, left -x, right +x. It is illegal off
/// the workbench and into the cell of any other object, dyers included. Left turns add a quarter
/// turn, right turns take one off. `kChangeColor` gives the target the colour of a dyer and is
/// legal only in a 4-neighbour cell of one; of two such dyers the first in `objects` counts.
/// @throws std::invalid_argument if `world.target` is not an object.
ActionOutcome applyAction(const World& world, Action action);

/// The same in place, for searches: changes `world` only if the action is legal.
std::optional<Obstruction> advance(World& world, Action action);

/// The cell a move leads to, on or off the workbench; the same cell for the other actions.
Cell cellAfter(Cell cell, Action action);

/// What came of a whole sequence of actions.
struct Replay {
  World world;                             ///< after the last legal action
  std::size_t steps = 0;                   ///< actions carried out
  std::optional<Obstruction> obstruction;  ///< of action number `steps`; nothing if all were legal
  std::optional<std::size_t> obstacle;     ///< the object that was run into

  bool succeeded() const { return !obstruction; }
};

/// Carries out actions until one is illegal. `replay(w, {})` leaves `w` as it is, and
/// `replay(w, a + b) == replay(replay(w, a).world, b)` for legal `a`.
/// @param moved the object that each action moves, which becomes the world's target; empty: all
///   move its target
/// @throws std::invalid_argument if these are more or fewer than the actions, or no objects.
Replay replay(World world, const ActionSequence& actions, std::span<const std::size_t> moved = {});

/// The object that action `step` of a sequence moves: `moved[step]`, or the world's target if
/// `moved` is empty.
std::size_t movedObject(const World& world, std::span<const std::size_t> moved, std::size_t step);

}  // namespace conceptplan
