#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/symbols.hpp"
#include "conceptplan/planners/state_validity.hpp"

namespace conceptplan {

enum class PlanStatus {
  kSolved,      ///< at least one plan
  kInfeasible,  ///< proved: there is no plan within the horizon
  /// Gave up, a plan may exist: at the limit of expansions, or cancelled; or what was left out may
  /// be one, such as improbable sequences, those beyond a beam's width or off a policy, and states
  /// whose validity check failed. `reason` says which.
  kLimit,
  kTimeout,  ///< gave up at the time limit; a plan may exist
  kFailed    ///< the planner itself failed; `reason` says how
};

/// "solved", "infeasible", "limit", "timeout", "failed".
std::string_view name(PlanStatus status);

/// One action sequence.
struct Plan {
  ActionSequence actions;
  double probability = 0;          ///< of reaching the goal symbols with every step legal, [0, 1]
  double cost = 0;                 ///< what the planner minimised
  std::vector<Symbols> predicted;  ///< most probable symbols after each step, [actions]
  /// The object that each action moves, by index into the scene, [actions]; `predicted` has its
  /// symbols. Empty in a plan for one target.
  std::vector<std::size_t> moved = {};

  bool operator==(const Plan&) const = default;
};

/// One step that a legality check ruled out.
struct Rejection {
  Symbols state{};  ///< before the action
  Action action = Action::kMoveFront;
  Invalidity cause = Invalidity::kNone;  ///< kNone: ruled out by action legality
  std::optional<std::size_t> object;     ///< index into the scene's objects, for a collision
  double value = 0;  ///< Pr[a | Omega] for action legality, else the clearance in metres
  /// The object that the action would move, by index into the scene; `state` has its symbols.
  /// Nothing where there is one target.
  std::optional<std::size_t> moved = {};

  bool operator==(const Rejection&) const = default;
};

/// The steps that were ruled out for one cause, by one object.
struct RejectionCount {
  Invalidity cause = Invalidity::kNone;  ///< as of a Rejection
  std::optional<std::size_t> object;     ///< as of a Rejection
  std::size_t steps = 0;
  double least = 0;     ///< of the values of these rejections
  double greatest = 0;  ///< of the values of these rejections

  bool operator==(const RejectionCount&) const = default;
};

/// What was ruled out of all that a search looked at.
struct RejectionTally {
  std::size_t states = 0;              ///< that were expanded; each counts once, however often
  std::vector<RejectionCount> counts;  ///< over all actions in these states; by cause, then object

  bool operator==(const RejectionTally&) const = default;
};

struct SearchStatistics {
  std::size_t expanded = 0;
  std::size_t generated = 0;
  std::size_t validity_checks = 0;

  bool operator==(const SearchStatistics&) const = default;
};

/// What a planner answers.
struct PlanResult {
  PlanStatus status = PlanStatus::kFailed;
  std::vector<Plan> plans;  ///< best first, distinct action sequences
  SearchStatistics statistics;
  std::vector<Rejection>
      rejections;  ///< beside the best plan, or around the start if there is none
  /// Where the query asks for it; nothing if no state was expanded, or by another program.
  std::optional<RejectionTally> ruled_out;
  /// Why there is no plan, or fewer than asked for because of a limit; `explanation` adds what
  /// blocks the way.
  std::string reason;
  /// For kInfeasible: the fewest objects of the scene, by index, without which there is a way to
  /// the goal, by some outcomes of the actions; that problem was compiled and searched. Empty where
  /// objects are not the reason, or not found to be; `reason` tells if finding them was given up.
  /// For one target it takes `PlanQuery::source`.
  std::vector<std::size_t> blocking;
  /// For kInfeasible: symbols in reach that are nearest the goal, of each target; empty if they
  /// are not known.
  std::vector<Symbols> nearest;

  bool operator==(const PlanResult&) const = default;
};

/// The reason with the objects that block the way: "...; without Pot 2 there would be a way".
/// @param names of all objects of the scene; without them they are called "object 2"
std::string explanation(const PlanResult& result, std::span<const std::string> names = {});

}  // namespace conceptplan
