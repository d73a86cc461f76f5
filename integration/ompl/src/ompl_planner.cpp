#include "conceptplan/ompl/ompl_planner.hpp"

#include <ompl/base/goals/GoalState.h>
#include <ompl/control/PathControl.h>
#include <ompl/control/PlannerData.h>
#include <ompl/control/planners/est/EST.h>
#include <ompl/control/planners/kpiece/KPIECE1.h>
#include <ompl/control/planners/pdst/PDST.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/control/planners/sst/SST.h>
#include <ompl/control/planners/syclop/SyclopRRT.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "conceptplan/ompl/action_space.hpp"
#include "conceptplan/ompl/symbol_space_information.hpp"
#include "conceptplan/planners/path_planning.hpp"
#include "ompl_console.hpp"
#include "option_range.hpp"
#include "path_search.hpp"
#include "symbol_regions.hpp"

namespace conceptplan {
namespace {

using ompl::control::SpaceInformationPtr;

constexpr int kFreeVolumeSamples = 1000;

/// A planner of OMPL whose own generator is seeded. Where it looks for near states it compares them
/// all, since OMPL's trees of neighbours draw from generators that cannot be seeded.
template <class Base>
class Seeded final : public Base {
 public:
  template <class... Arguments>
  explicit Seeded(std::uint32_t seed, const Arguments&... arguments) : Base(arguments...) {
    this->rng_.setLocalSeed(seed);
    if constexpr (requires(Seeded & self) { self.nn_; }) this->nn_ = makeNeighbours();
    if constexpr (requires(Seeded & self) { self.witnesses_; }) this->witnesses_ = makeNeighbours();
  }

 private:
  auto makeNeighbours() {
    using Node = typename Base::Motion;
    const auto neighbours = std::make_shared<ompl::NearestNeighborsLinear<Node*>>();
    neighbours->setDistanceFunction(
        [this](const Node* a, const Node* b) { return this->distanceFunction(a, b); });
    return neighbours;
  }
};

template <class Base>
ompl::base::PlannerPtr makeBiased(std::uint32_t seed, double goal_bias,
                                  const SpaceInformationPtr& space) {
  auto planner = std::make_shared<Seeded<Base>>(seed, space);
  planner->setGoalBias(goal_bias);
  return planner;
}

ompl::base::PlannerPtr makeSyclop(std::uint32_t seed, const SpaceInformationPtr& space) {
  const auto states = std::static_pointer_cast<SymbolStateSpace>(space->getStateSpace());
  const ompl::control::DecompositionPtr regions = std::make_shared<SymbolRegions>(states);
  auto planner = std::make_shared<Seeded<ompl::control::SyclopRRT>>(seed, space, regions);
  planner->setNumFreeVolumeSamples(kFreeVolumeSamples);
  return planner;
}

ompl::base::PlannerPtr makePlanner(OmplAlgorithm algorithm, std::uint32_t seed, double goal_bias,
                                   const SpaceInformationPtr& space) {
  switch (algorithm) {
    case OmplAlgorithm::kRrt:
      return makeBiased<ompl::control::RRT>(seed, goal_bias, space);
    case OmplAlgorithm::kEst:
      return makeBiased<ompl::control::EST>(seed, goal_bias, space);
    case OmplAlgorithm::kKpiece:
      return makeBiased<ompl::control::KPIECE1>(seed, goal_bias, space);
    case OmplAlgorithm::kSst:
      return makeBiased<ompl::control::SST>(seed, goal_bias, space);
    case OmplAlgorithm::kPdst:
      return makeBiased<ompl::control::PDST>(seed, goal_bias, space);
    case OmplAlgorithm::kSyclopRrt:
      break;
  }
  return makeSyclop(seed, space);
}

/// The states along a path, replayed from its start action by action; nothing if a step of it is
/// not legal or not valid.
std::optional<std::vector<StateId>> replay(const SpaceInformationPtr& space,
                                           const ompl::control::PathControl& path) {
  const auto* states = space->getStateSpace()->as<SymbolStateSpace>();
  std::vector<StateId> along{SymbolStateSpace::id(path.getState(0))};
  for (unsigned int i = 0; i < path.getControlCount(); ++i) {
    const std::optional<Action> action = ActionSpace::action(path.getControl(i));
    if (!action) continue;
    for (long step = std::lround(path.getControlDuration(i)); step > 0; --step) {
      const StateId next = states->next(along.back(), *action);
      if (!states->contains(next) || !states->graph().valid(next)) return std::nullopt;
      along.push_back(next);
    }
  }
  return along;
}

/// From the first to the last of the states by actions that each lead as far on among them as one
/// action can.
StatePath shortened(const SymbolStateSpace& states, const std::vector<StateId>& along) {
  StatePath path;
  for (std::size_t at = 0; along[at] != along.back();) {
    std::size_t farthest = at;
    Action taken{};
    for (const Action action : kActions) {
      const StateId next = states.next(along[at], action);
      for (std::size_t to = along.size() - 1; to > farthest; --to) {
        if (along[to] != next) continue;
        farthest = to;
        taken = action;
      }
    }
    at = farthest;
    path.actions.push_back(taken);
    path.states.push_back(along[at]);
    path.cost += kNat;
  }
  return path;
}

/// A goal that tells when a state first reaches it: planners that improve their paths go on then.
class WatchedGoal final : public ompl::base::GoalState {
 public:
  WatchedGoal(const SpaceInformationPtr& space, std::function<void()> reached)
      : GoalState(space), reached_(std::move(reached)) {}

  using GoalState::isSatisfied;

  bool isSatisfied(const ompl::base::State* state, double* distance) const override {
    const bool satisfied = GoalState::isSatisfied(state, distance);
    if (satisfied) reached_();
    return satisfied;
  }

 private:
  std::function<void()> reached_;
};

/// Runs of one algorithm on one graph.
class OmplRuns {
 public:
  OmplRuns(const SymbolGraph& graph, OmplAlgorithm algorithm, const OmplPlannerOptions& options,
           std::uint64_t seed)
      : algorithm_(algorithm), options_(options), seeds_(seed) {
    SymbolSpaceOptions space;
    space.legality_threshold = options.legality_threshold;
    space.control_samples = static_cast<unsigned int>(options.control_samples);
    // The graph outlives the runs.
    space_ = makeSpaceInformation({std::shared_ptr<void>(), &graph}, space);
  }

  /// From start to goal; nothing if the guard stopped the run.
  /// @throws std::runtime_error if OMPL gives up by itself.
  std::optional<StatePath> run(SearchGuard& guard, SearchStatistics& statistics) {
    auto* states = space_->getStateSpace()->as<SymbolStateSpace>();
    states->seedSamplers(seeds_());
    space_->getControlSpace()->as<ActionSpace>()->seedSamplers(seeds_());
    const auto problem = std::make_shared<ompl::base::ProblemDefinition>(space_);
    setStartAndGoal(*problem);
    std::optional<std::size_t> last;  // expansion, once there is a path
    const auto goal = std::make_shared<WatchedGoal>(space_, [&] {
      if (!last) last = statistics.expanded + options_.improvement_steps;
    });
    const SymbolStateSpace::StateType goal_state(states->graph().mostProbableGoal());
    goal->setState(&goal_state);
    problem->setGoal(goal);
    const ompl::base::PlannerPtr planner =
        makePlanner(algorithm_, static_cast<std::uint32_t>(seeds_()), options_.goal_bias, space_);
    planner->setProblemDefinition(problem);
    planner->setup();
    const std::size_t before = statistics.expanded;
    const ompl::base::PlannerStatus status = planner->solve(ompl::base::PlannerTerminationCondition(
        [&] { return (last && statistics.expanded >= *last) || !guard.expand(statistics); }));
    if (statistics.expanded == before && !guard.stopped()) {
      throw std::runtime_error(planner->getName() +
                               " ends before its first step: " + status.asString());
    }
    ompl::control::PlannerData tree(space_);
    planner->getPlannerData(tree);
    statistics.generated += tree.numVertices();
    for (unsigned int i = 0; i < tree.numVertices(); ++i) {
      guard.note(SymbolStateSpace::id(tree.getVertex(i).getState()));
    }
    if (!problem->hasExactSolution()) return std::nullopt;
    const std::optional<std::vector<StateId>> along = replay(
        space_, *std::static_pointer_cast<ompl::control::PathControl>(problem->getSolutionPath()));
    if (!along || along->back() != states->graph().mostProbableGoal()) return std::nullopt;
    return shortened(*states, *along);
  }

 private:
  OmplAlgorithm algorithm_;
  OmplPlannerOptions options_;
  std::mt19937_64 seeds_;
  SpaceInformationPtr space_;
};

}  // namespace

OmplPlanner::OmplPlanner(OmplAlgorithm algorithm, const OmplPlannerOptions& options)
    : algorithm_(algorithm), options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("goal_bias", options.goal_bias, 0, 1);
  checkOptionRange("control_samples", static_cast<double>(options.control_samples), 1, 100);
}

PlanResult OmplPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  return planByPaths(graph, query, options_.legality_threshold, [&](const PathTask& task) {
    SearchLimits half = query.limits;
    half.max_expansions = std::max<std::size_t>(half.max_expansions / 2, 1);
    SearchGuard proof(half, task.guard.expanded());
    std::vector<StatePath> paths =
        shortestPaths(graph, options_.legality_threshold, task.start, task.goal,
                      {1, query.limits.horizon}, proof, task.statistics);
    const bool infeasible = paths.empty() && !proof.stopped();
    if (infeasible || (!paths.empty() && task.start == task.goal)) return paths;

    paths.clear();  // there is one; OMPL shall find it
    const OmplSilence silence;
    try {
      OmplRuns runs(graph, algorithm_, options_, query.seed);
      for (std::size_t i = 0; paths.size() < query.top && (i < query.top || paths.empty()); ++i) {
        std::optional<StatePath> path = runs.run(task.guard, task.statistics);
        const auto same = [&](const StatePath& other) { return other.actions == path->actions; };
        if (path && path->actions.size() <= query.limits.horizon &&
            std::none_of(paths.begin(), paths.end(), same)) {
          paths.push_back(std::move(*path));
        }
        if (task.guard.stopped()) break;
      }
    } catch (const std::exception& error) {
      task.guard.stop(PlanStatus::kFailed, std::string("OMPL: ") + error.what());
    }
    std::sort(paths.begin(), paths.end(), [](const StatePath& a, const StatePath& b) {
      return std::tie(a.cost, a.actions) < std::tie(b.cost, b.actions);
    });
    return paths;
  });
}

}  // namespace conceptplan
