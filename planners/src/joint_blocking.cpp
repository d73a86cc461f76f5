#include "joint_blocking.hpp"

#include <algorithm>

namespace conceptplan {
namespace {

/// States of single targets worked out, in all.
constexpr std::size_t kMostStates = 1'000'000;

JointProblem only(const SceneObjects& kept, const JointProblem& problem) {
  JointProblem rest{problem.workbench, {}, problem.targets};
  for (const std::size_t object : kept) rest.objects.push_back(problem.objects[object]);
  for (TargetGoal& target : rest.targets) {
    const auto place = std::ranges::lower_bound(kept, target.object);
    target.object = static_cast<std::size_t>(place - kept.begin());
  }
  return rest;
}

/// What becomes of a problem without some of its objects.
class JointRemovals {
 public:
  JointRemovals(const SymbolicModel& model, const JointProblem& problem,
                const StateValidity& validity, const StepRules& rules,
                const JointSearchOptions& search, SearchGuard& guard, SearchStatistics& statistics)
      : model_(model),
        problem_(problem),
        validity_(validity),
        rules_(rules),
        search_(search),
        guard_(guard),
        statistics_(statistics) {
    search_.top = 1;
    search_.horizon = kMostSteps;
    SceneObjects targets;
    for (const TargetGoal& target : problem.targets) targets.push_back(target.object);
    all_ = removableObjects(model, problem.objects, joined({}, targets));
  }

  const RemovableObjects& all() const { return all_; }

  std::optional<Removal> trial(const SceneObjects& removed) {
    const SceneObjects kept = allBut(removed, problem_.objects.size());
    const JointProblem rest = only(kept, problem_);
    SearchStatistics making;
    auto space = JointSpace::make(model_, rest, validity_, rules_, guard_, making);
    if (!space) return std::nullopt;
    for (std::size_t i = 0; i < space->numTargets(); ++i) states_ += space->target(i).numStates();
    Removal removal = found(*space, kept);
    statistics_.validity_checks += space->validityChecks();
    if (guard_.stopped() || states_ > kMostStates) return std::nullopt;
    removal.in_the_way = without(removal.in_the_way, removed);
    return removal;
  }

 private:
  Removal found(JointSpace& space, const SceneObjects& kept) {
    if (space.isShutIn()) {
      SceneObjects met;
      for (const std::size_t object : space.inTheWay(guard_)) met.push_back(kept[object]);
      return {{}, joined(all_.watched, met)};
    }
    if (!space.contradiction().empty()) return {{}, all_.watched};
    std::vector<JointState> expanded;
    const std::vector<JointPath> paths =
        bestJointPaths(space, search_, guard_, statistics_, expanded);
    if (paths.empty()) return {{}, joined(all_.watched, all_.met)};
    return {paths.front().steps.size(), {}};
  }

  const SymbolicModel& model_;
  const JointProblem& problem_;
  const StateValidity& validity_;
  const StepRules& rules_;
  JointSearchOptions search_;
  SearchGuard& guard_;
  SearchStatistics& statistics_;
  RemovableObjects all_;
  std::size_t states_ = 0;
};

}  // namespace

BlockingObjects blockingObjects(const SymbolicModel& model, const JointProblem& problem,
                                const StateValidity& validity, const StepRules& rules,
                                const JointSearchOptions& search, SearchGuard& guard,
                                SearchStatistics& statistics) {
  JointRemovals removals(model, problem, validity, rules, search, guard, statistics);
  return fewestBlocking(removals.all(),
                        [&](const SceneObjects& removed) { return removals.trial(removed); });
}

}  // namespace conceptplan
