// What a joint space tells of a failure: what was ruled out, what is in the way, what is nearest.
#include <algorithm>
#include <limits>
#include <tuple>

#include "joint_space.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kNotReached = std::numeric_limits<std::size_t>::max();

}  // namespace

void JointSpace::forEachRejection(JointState state,
                                  const std::function<void(const Rejection&)>& visit) {
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const std::vector<Symbols> others = othersOf(state, i);
    const std::span<const TargetStep> all = steps(state, i);
    for (const Action action : kActions) {
      Rejection rejection{symbols(state, i), action, Invalidity::kNone,
                          std::nullopt,      0,      problem_.targets[i].object};
      rejection.value = targets_[i].legality(part(state, i), action, others);
      if (!targets_[i].isLegal(rejection.value)) {
        visit(rejection);
        continue;
      }
      const auto step = std::find_if(
          all.begin(), all.end(), [action](const TargetStep& any) { return any.action == action; });
      if (step == all.end()) continue;  // it changes nothing
      Verdict verdict = verdictAt(i, step->next);
      if (verdict.cause == Invalidity::kCollision) rejection.object = still_[verdict.object];
      for (std::size_t j = 0; verdict.valid() && j < targets_.size(); ++j) {
        if (j == i) continue;
        verdict = together(i, step->next, j, part(state, j));
        if (verdict.cause == Invalidity::kCollision) rejection.object = problem_.targets[j].object;
      }
      if (verdict.valid()) continue;
      rejection.cause = verdict.cause;
      rejection.value = verdict.clearance_m;
      visit(rejection);
    }
  }
}

void JointSpace::measureNearness(SearchGuard& guard) {
  free_to_goal_.clear();
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    free_to_goal_.push_back(ranksToGoal(
        i, [](const Verdict&) { return true; }, guard));
  }
}

JointNearness JointSpace::nearness(std::size_t target, TargetState state) const {
  const PathRank rank = free_to_goal_[target][state];
  const bool leads_there = rank != kOutOfReach;
  JointNearness nearness{leads_there ? 0u : 1u, leads_there ? rank : 0, 0};
  const Symbols here = targets_[target].symbols(state);
  const Symbols goal = targets_[target].symbols(part(goal_, target));
  for (std::size_t k = 0; k < kNumConcepts; ++k) nearness.different += here[k] != goal[k] ? 1 : 0;
  return nearness;
}

JointNearness JointSpace::nearness(JointState state) const {
  JointNearness sum;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const JointNearness of_target = nearness(i, part(state, i));
    sum.out_of_reach += of_target.out_of_reach;
    sum.rank = std::min(sum.rank + of_target.rank, kFarthest);
    sum.different += of_target.different;
  }
  return sum;
}

JointState JointSpace::nearestAlone(SearchGuard& guard) const {
  JointState nearest = 0;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const std::vector<std::size_t> steps = stepsAlone(i, guard);
    TargetState best = part(start_, i);
    std::tuple least{nearness(i, best), std::size_t{0}};
    for (TargetState state = 0; state < steps.size() && guard.goesOn(); ++state) {
      if (steps[state] == kNotReached) continue;
      const std::tuple rank{nearness(i, state), steps[state]};
      if (rank >= least) continue;
      least = rank;
      best = state;
    }
    nearest += best * stride_[i];
  }
  return nearest;
}

void JointSpace::aimAt(JointState goal, SearchGuard& guard) {
  goal_ = goal;
  setRanksToGoal(guard);
}

std::vector<std::size_t> JointSpace::stepsAlone(std::size_t target, SearchGuard& guard) const {
  std::vector<std::size_t> steps(targets_[target].numStates(), kNotReached);
  std::vector<TargetState> open{part(start_, target)};
  steps[open.front()] = 0;
  for (std::size_t i = 0; i < open.size() && guard.goesOn(); ++i) {
    for (const TargetStep& step : targets_[target].possibleSteps(open[i])) {
      if (steps[step.next] != kNotReached || isRuledOut(verdictAt(target, step.next))) continue;
      steps[step.next] = steps[open[i]] + 1;
      open.push_back(step.next);
    }
  }
  return steps;
}

SceneObjects JointSpace::inTheWay(SearchGuard& guard) const {
  std::size_t shut_in = 0;
  while (to_goal_[shut_in][part(start_, shut_in)] != kOutOfReach) ++shut_in;
  const std::vector<std::size_t> steps = stepsAlone(shut_in, guard);
  SceneObjects met;
  for (TargetState state = 0; state < steps.size() && guard.goesOn(); ++state) {
    if (steps[state] == kNotReached) continue;
    for (const TargetStep& step : targets_[shut_in].possibleSteps(state)) {
      const Verdict& verdict = verdictAt(shut_in, step.next);
      if (verdict.cause == Invalidity::kCollision) met.push_back(still_[verdict.object]);
    }
  }
  return joined({}, met);
}

}  // namespace conceptplan
