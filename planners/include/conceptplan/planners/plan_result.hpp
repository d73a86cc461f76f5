#pragma once

#include <cstddef>
#include <optional>
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
  kLimit,       ///< gave up at the limit of expansions, or was cancelled; a plan may exist
  kTimeout,     ///< gave up at the time limit; a plan may exist
  kFailed       ///< the planner itself failed; `reason` says how
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

  bool operator==(const Rejection&) const = default;
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
      rejections;      ///< beside the best plan, or around the start if there is none
  std::string reason;  ///< why there is no plan, or fewer than asked for because of a limit
  /// For kInfeasible: the fewest objects of the scene, by index, without which the target could
  /// get to the goal; empty where objects are not the reason, or not found to be.
  std::vector<std::size_t> blocking;
  std::optional<Symbols> nearest;  ///< for kInfeasible: symbols in reach that are nearest the goal

  bool operator==(const PlanResult&) const = default;
};

}  // namespace conceptplan
