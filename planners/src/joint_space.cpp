#include "joint_space.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "path_search.hpp"

namespace conceptplan {
namespace {

/// States whose validity is asked for between two looks at the limits.
constexpr std::size_t kCheckedAtOnce = 16;

constexpr JointState kMostJointStates = std::numeric_limits<std::int64_t>::max();

bool isNotRuledOut(const Verdict& verdict) { return !isRuledOut(verdict); }

std::string nameOf(const TargetGoal& target) {
  return target.name.empty() ? "object " + std::to_string(target.object) : target.name;
}

}  // namespace

std::optional<JointSpace> JointSpace::make(const SymbolicModel& model, const JointProblem& problem,
                                           const StateValidity& validity, const StepRules& rules,
                                           SearchGuard& guard, SearchStatistics& statistics) {
  JointSpace space(model, problem, validity);
  space.build(rules, guard);
  statistics.validity_checks = space.validityChecks();
  if (guard.stopped()) return std::nullopt;
  return space;
}

void JointSpace::build(const StepRules& rules, SearchGuard& guard) {
  together_.resize(problem_.targets.size() * problem_.targets.size());
  watching_steps_.resize(problem_.targets.size());
  std::vector<bool> moves(problem_.objects.size(), false);
  for (const TargetGoal& target : problem_.targets) moves[target.object] = true;
  std::vector<Symbols> still;
  for (std::size_t i = 0; i < problem_.objects.size(); ++i) {
    scene_.push_back(mostProbable(problem_.objects[i]));
    if (moves[i]) continue;
    still_.push_back(i);
    still.push_back(scene_.back());
  }
  JointState states = 1;
  for (std::size_t i = 0; i < problem_.targets.size(); ++i) {
    const TargetGoal& target = problem_.targets[i];
    targets_.emplace_back(model_, scene_, moves, target.object, rules, guard);
    if (targets_[i].numStates() > kMostJointStates / states) {
      throw std::invalid_argument("the joint states of " + std::to_string(problem_.targets.size()) +
                                  " targets cannot be counted in 63 bits");
    }
    stride_.push_back(states);
    start_ += states * targets_[i].state(scene_[target.object]);
    goal_ += states * targets_[i].state(mostProbable(target.goal));
    states *= targets_[i].numStates();
    checkStanding(i, still, guard);
    if (guard.stopped()) return;
  }
  setRanksToGoal(guard);
  if (!guard.stopped()) contradiction_ = findContradiction();
}

void JointSpace::setRanksToGoal(SearchGuard& guard) {
  to_goal_.clear();
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    to_goal_.push_back(ranksToGoal(i, isNotRuledOut, guard));
  }
}

void JointSpace::checkStanding(std::size_t target, const std::vector<Symbols>& still,
                               SearchGuard& guard) {
  const JointTarget& moved = targets_[target];
  const std::array<bool, kNumConcepts> concepts = validity_.dependsOn();
  Standing& standing = standing_.emplace_back();
  std::unordered_map<std::uint64_t, std::size_t> views;
  std::vector<Symbols> asked;
  for (TargetState state = 0; state < moved.numStates(); ++state) {
    if (!guard.goesOn()) return;
    Symbols seen = moved.symbols(0);
    const Symbols symbols = moved.symbols(state);
    for (std::size_t k = 0; k < kNumConcepts; ++k) {
      if (concepts[k]) seen[k] = symbols[k];
    }
    const auto [view, is_new] = views.try_emplace(moved.state(seen), asked.size());
    if (is_new) asked.push_back(symbols);
    standing.view.push_back(view->second);
  }
  for (std::span<const Symbols> rest = asked; !rest.empty();) {
    if (!guard.goesOn()) return;
    const std::size_t count = std::min(rest.size(), kCheckedAtOnce);
    validity_checks_ += count;
    const std::vector<Verdict> more =
        validity_.checkAll(problem_.workbench, model_.grounding, rest.first(count), still);
    standing.verdicts.insert(standing.verdicts.end(), more.begin(), more.end());
    rest = rest.subspan(count);
  }
  standing.is_counted.assign(asked.size(), false);
}

std::vector<PathRank> JointSpace::ranksToGoal(std::size_t target,
                                              const std::function<bool(const Verdict&)>& passable,
                                              SearchGuard& guard) const {
  const JointTarget& moved = targets_[target];
  std::vector<StateEdge> edges;
  for (TargetState state = 0; state < moved.numStates(); ++state) {
    if (!guard.goesOn()) return {};
    for (const TargetStep& step : moved.possibleSteps(state)) {
      if (!passable(verdictAt(target, step.next))) continue;
      edges.push_back({StateId(state), StateId(step.next), rankOf(step.cost, 1)});
    }
  }
  return leastCosts(moved.numStates(), StateId(part(goal_, target)), edges, guard);
}

std::string JointSpace::findContradiction() {
  std::string reason;
  std::size_t sentences = 0, shut_in = 0;
  const auto add = [&](const std::string& sentence) {
    reason += (reason.empty() ? "" : "; ") + sentence;
    ++sentences;
  };
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const TargetGoal& target = problem_.targets[i];
    const Symbols goal = mostProbable(target.goal);
    bool frozen = false;
    for (const Concept which : kConcepts) {
      if (!targets_[i].isFrozenHere(which)) continue;
      if (scene_[target.object][index(which)] == goal[index(which)]) continue;
      frozen = true;
      add(std::string(name(which)) + " of " + nameOf(target) +
          " must change, and nothing here changes it");
    }
    if (!frozen && to_goal_[i][part(start_, i)] == kOutOfReach) {
      add(nameOf(target) + " cannot get to its goal, wherever the other targets are");
      ++shut_in;
    }
    for (std::size_t j = 0; j < i; ++j) {
      const bool both_there =
          part(start_, i) == part(goal_, i) && part(start_, j) == part(goal_, j);
      if (both_there || !isRuledOut(together(j, part(goal_, j), i, part(goal_, i)))) continue;
      add("the goals of " + nameOf(problem_.targets[j]) + " and " + nameOf(target) +
          " rule each other out");
    }
  }
  is_shut_in_ = sentences > 0 && shut_in == sentences;
  return reason;
}

PathRank JointSpace::bound(JointState state) const {
  PathRank sum = 0;
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const PathRank rank = to_goal_[i][part(state, i)];
    if (rank == kOutOfReach) return kOutOfReach;
    sum = std::min(sum + rank, kFarthest);
  }
  return sum;
}

bool JointSpace::stands(std::size_t target, TargetState state) {
  const Verdict& verdict = verdictAt(target, state);
  if (verdict.cause == Invalidity::kCheckFailed) {
    Standing& views = standing_[target];
    const std::size_t view = views.view[state];
    if (!views.is_counted[view]) ++failed_checks_;
    views.is_counted[view] = true;
  }
  return verdict.valid();
}

const Verdict& JointSpace::together(std::size_t a, TargetState state_a, std::size_t b,
                                    TargetState state_b) {
  if (a > b) return together(b, state_b, a, state_a);
  const std::uint64_t key =
      standing_[a].view[state_a] * standing_[b].verdicts.size() + standing_[b].view[state_b];
  const auto [entry, is_new] = together_[a * targets_.size() + b].try_emplace(key);
  if (is_new) {
    ++validity_checks_;
    const Symbols other = targets_[b].symbols(state_b);
    entry->second = validity_.check(problem_.workbench, model_.grounding,
                                    targets_[a].symbols(state_a), {&other, 1});
    if (entry->second.cause == Invalidity::kCheckFailed) ++failed_checks_;
  }
  return entry->second;
}

std::span<const TargetStep> JointSpace::steps(JointState state, std::size_t target) {
  const JointTarget& moved = targets_[target];
  JointState key = part(state, target) * stride_[target];
  bool watches = false;
  for (std::size_t j = 0; j < targets_.size(); ++j) {
    if (j == target || !moved.watches(problem_.targets[j].object)) continue;
    watches = true;
    key += part(state, j) * stride_[j];
  }
  if (!watches) return moved.possibleSteps(part(state, target));
  const auto [entry, is_new] = watching_steps_[target].try_emplace(key);
  if (is_new) {
    entry->second = moved.steps(part(state, target), othersOf(state, target));
  }
  return entry->second;
}

std::vector<Symbols> JointSpace::othersOf(JointState state, std::size_t target) const {
  std::vector<Symbols> others = scene_;
  for (std::size_t j = 0; j < targets_.size(); ++j) {
    others[problem_.targets[j].object] = symbols(state, j);
  }
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(problem_.targets[target].object));
  return others;
}

void JointSpace::successors(JointState state, std::vector<JointSuccessor>& next) {
  next.clear();
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const TargetState from = part(state, i);
    for (const TargetStep& step : steps(state, i)) {
      if (!stands(i, step.next)) continue;
      bool free = true;
      for (std::size_t j = 0; free && j < targets_.size(); ++j) {
        free = j == i || together(i, step.next, j, part(state, j)).valid();
      }
      if (free) next.push_back({i, step, state + step.next * stride_[i] - from * stride_[i]});
    }
  }
}

}  // namespace conceptplan
