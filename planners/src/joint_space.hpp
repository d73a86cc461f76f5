#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "blocking_objects.hpp"
#include "conceptplan/planners/plan_result.hpp"
#include "conceptplan/planners/search_guard.hpp"
#include "conceptplan/planners/state_validity.hpp"
#include "joint_state.hpp"
#include "joint_target.hpp"
#include "path_rank.hpp"

namespace conceptplan {

/// Whether a check has shown that it cannot be.
inline bool isRuledOut(const Verdict& verdict) {
  return !verdict.valid() && verdict.cause != Invalidity::kCheckFailed;
}

/// The product of the targets' states, never built: steps are worked out state by state, and what
/// may be asked again is kept. Objects have their most probable symbols, actions their most
/// probable outcome. For one thread; keeps references.
class JointSpace {
 public:
  /// Nothing if a limit strikes.
  /// @param statistics gets the validity checks, also of what was cut off
  /// @throws std::invalid_argument if the joint states cannot be counted in 63 bits.
  static std::optional<JointSpace> make(const SymbolicModel& model, const JointProblem& problem,
                                        const StateValidity& validity, const StepRules& rules,
                                        SearchGuard& guard, SearchStatistics& statistics);

  std::size_t numTargets() const { return targets_.size(); }
  const JointTarget& target(std::size_t i) const { return targets_[i]; }
  JointState start() const { return start_; }
  JointState goal() const { return goal_; }
  std::size_t validityChecks() const { return validity_checks_; }

  /// How many views of targets, and pairs of views, were met whose validity check failed: what
  /// leads over them is no way out of a state, although it may be one.
  std::size_t failedChecks() const { return failed_checks_; }

  /// Most probable symbols of a target in a state.
  Symbols symbols(JointState state, std::size_t target) const {
    return targets_[target].symbols(part(state, target));
  }

  /// Replaces the vector's content by all ways out of the state, by target, then by action.
  void successors(JointState state, std::vector<JointSuccessor>& next);

  /// A lower bound of the rank of every way to the goal: the sum over the targets of the least rank
  /// at which each gets to its goal with the other targets out of its way, and where they serve it
  /// best. Admissible and consistent, since a step moves one target, and is one of its possible
  /// steps. States whose validity check failed count as valid here. kOutOfReach where a target
  /// cannot get there.
  PathRank bound(JointState state) const;

  /// Why there is no way to the goal, as far as it shows without a search; empty if it does not.
  std::string contradiction() const { return contradiction_; }
  /// Whether it is that some targets cannot get to their goals wherever the others are, and no
  /// more.
  bool isShutIn() const { return is_shut_in_; }

  /// Calls `visit` with each step of each target that a check rules out in the state, by target,
  /// then by action. The object of a collision is another target if nothing else is met.
  void forEachRejection(JointState state, const std::function<void(const Rejection&)>& visit);

  /// @pre `measureNearness` has come to its end.
  JointNearness nearness(JointState state) const;
  /// Once the guard has been stopped it has not come to its end.
  void measureNearness(SearchGuard& guard);

  /// The state in which each target by itself gets nearest to its goal, the other targets out of
  /// its way: by `nearness`, then by the fewest steps. No state in reach is nearer.
  /// @pre as of `nearness` @param guard once it has been stopped, the state has no use
  JointState nearestAlone(SearchGuard& guard) const;

  /// Makes another state the goal. @param guard once it has been stopped, the space has no use
  void aimAt(JointState goal, SearchGuard& guard);

  /// The objects that are no targets and that the first of those targets meets that cannot get to
  /// their goals by themselves: it gets no farther while all of them are there.
  /// @pre `isShutIn` @param guard once it has been stopped, they have no use
  SceneObjects inTheWay(SearchGuard& guard) const;

 private:
  struct Standing {
    std::vector<std::size_t> view;  ///< of each state: its number among those checked together
    std::vector<Verdict> verdicts;  ///< among the objects that are no targets, [views]
    std::vector<bool> is_counted;   ///< in `failed_checks_`, [views]
  };

  JointSpace(const SymbolicModel& model, const JointProblem& problem, const StateValidity& validity)
      : model_(model), problem_(problem), validity_(validity) {}

  TargetState part(JointState state, std::size_t target) const {
    return static_cast<TargetState>(state / stride_[target] % targets_[target].numStates());
  }
  /// What they make is incomplete once the guard has been stopped.
  void build(const StepRules& rules, SearchGuard& guard);
  void checkStanding(std::size_t target, const std::vector<Symbols>& still, SearchGuard& guard);
  /// @param passable of the verdict of a state
  std::vector<PathRank> ranksToGoal(std::size_t target,
                                    const std::function<bool(const Verdict&)>& passable,
                                    SearchGuard& guard) const;
  void setRanksToGoal(SearchGuard& guard);
  JointNearness nearness(std::size_t target, TargetState state) const;
  /// Fewest steps from the start of a target to each of its states with the other targets out of
  /// its way; kNotReached where there are none.
  std::vector<std::size_t> stepsAlone(std::size_t target, SearchGuard& guard) const;

  std::string findContradiction();
  const Verdict& verdictAt(std::size_t target, TargetState state) const {
    return standing_[target].verdicts[standing_[target].view[state]];
  }
  bool stands(std::size_t target, TargetState state);
  const Verdict& together(std::size_t a, TargetState state_a, std::size_t b, TargetState state_b);
  /// Symbols of all objects but a target.
  std::vector<Symbols> othersOf(JointState state, std::size_t target) const;
  std::span<const TargetStep> steps(JointState state, std::size_t target);

  const SymbolicModel& model_;
  const JointProblem& problem_;
  const StateValidity& validity_;
  std::vector<Symbols> scene_;
  std::vector<std::size_t> still_;  // the objects that are no targets
  std::vector<JointTarget> targets_;
  std::vector<JointState> stride_;
  std::vector<Standing> standing_;
  std::vector<std::vector<PathRank>> to_goal_;       // [targets][states]
  std::vector<std::vector<PathRank>> free_to_goal_;  // [targets][states], with nothing in the way
  JointState start_ = 0;
  JointState goal_ = 0;
  std::string contradiction_;
  bool is_shut_in_ = false;
  std::size_t validity_checks_ = 0;
  std::size_t failed_checks_ = 0;
  std::vector<std::unordered_map<std::uint64_t, Verdict>> together_;  // [pairs of targets]
  std::vector<std::unordered_map<JointState, std::vector<TargetStep>>>
      watching_steps_;  // [targets]
};

}  // namespace conceptplan
