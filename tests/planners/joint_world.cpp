#include "planners/joint_world.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "conceptplan/domain/simulation/random_stream.hpp"
#include "conceptplan/planners/state_validity.hpp"
#include "planners/grid_world.hpp"
#include "planners/learned_world.hpp"
#include "planners/random_world.hpp"

namespace conceptplan::testing {
namespace {

Symbols placed(const Placement& place) {
  Symbols symbols{};
  symbols[index(Concept::kPositionX)] = static_cast<SymbolId>(place.x);
  symbols[index(Concept::kPositionY)] = static_cast<SymbolId>(place.y);
  symbols[index(Concept::kRotation)] = static_cast<SymbolId>(place.rotation);
  return symbols;
}

/// Numbers below `count`, each once, in a drawn order.
std::vector<std::size_t> shuffled(std::size_t count, RandomStream& draws) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(numbers[i - 1], numbers[draws.below(i)]);
  return numbers;
}

/// The symbols of all objects.
using Scene = std::vector<Symbols>;

struct SceneStep {
  std::size_t target;
  Action action;
  Scene scene;
  double cost;
};

/// All steps from a scene, straight from the definitions.
class StepOracle {
 public:
  StepOracle(const JointWorld& world, double legality_threshold, double step_discount,
             bool count_actions)
      : world_(world),
        threshold_(legality_threshold),
        discount_(step_discount),
        count_actions_(count_actions) {
    for (const SymbolBelief& belief : world.problem.objects) start_.push_back(mostProbable(belief));
  }

  const Scene& start() const { return start_; }

  bool isGoal(const Scene& scene) const {
    return std::ranges::all_of(world_.problem.targets, [&](const TargetGoal& target) {
      return scene[target.object] == mostProbable(target.goal);
    });
  }

  std::vector<SceneStep> steps(const Scene& scene) const {
    std::vector<SceneStep> steps;
    for (std::size_t i = 0; i < world_.problem.targets.size(); ++i) {
      const std::size_t object = world_.problem.targets[i].object;
      Scene others = scene;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(object));
      for (const Action action : kActions) addStep(scene, i, object, others, action, steps);
    }
    return steps;
  }

 private:
  void addStep(const Scene& scene, std::size_t target, std::size_t object, const Scene& others,
               Action action, std::vector<SceneStep>& steps) const {
    const SymbolicModel& model = world_.model;
    const Surroundings surroundings{model.grounding, scene[object], others};
    if (!model.transitions.isDefined(action, surroundings)) return;
    if (model.legality.probability(action, surroundings) <= threshold_) return;
    Scene next = scene;
    double probability = 1;
    for (const Concept which : kConcepts) {
      const std::vector<double> row = model.transitions.distribution(action, which, surroundings);
      const auto best = std::max_element(row.begin(), row.end());
      next[object][index(which)] = static_cast<SymbolId>(best - row.begin());
      probability *= *best;
    }
    if (next == scene) return;
    const GridValidity validity;
    if (!validity.check(world_.problem.workbench, model.grounding, next[object], others).valid()) {
      return;
    }
    const double cost = count_actions_ ? 1 : -std::log(probability) - std::log1p(-discount_);
    steps.push_back({target, action, std::move(next), cost});
  }

  const JointWorld& world_;
  Scene start_;
  double threshold_;
  double discount_;
  bool count_actions_;
};

}  // namespace

JointWorld jointGrid(int columns, int rows, int rotations,
                     const std::vector<std::pair<Placement, Placement>>& targets,
                     const std::vector<Placement>& obstacles) {
  const GridWorld grid = gridWorld(columns, rows, rotations, 0, 1);
  const ConceptCardinality& cardinality = grid.model.cardinality();
  JointWorld world{grid.model, {grid.problem.initial.workbench, {}, {}}};
  for (const auto& [start, goal] : targets) {
    world.problem.targets.push_back(
        {world.problem.objects.size(), certain(placed(goal), cardinality)});
    world.problem.objects.push_back(certain(placed(start), cardinality));
  }
  for (const Placement& obstacle : obstacles) {
    world.problem.objects.push_back(certain(placed(obstacle), cardinality));
  }
  return world;
}

JointWorld drawnJointGrid(int columns, int rows, int rotations, std::size_t targets,
                          std::size_t obstacles, std::uint64_t seed) {
  RandomStream draws({seed, 23});
  const auto width = static_cast<std::size_t>(columns);
  const auto cells = width * static_cast<std::size_t>(rows);
  const auto place = [&](std::size_t cell) {
    return Placement{cell % width, cell / width, draws.below(static_cast<std::size_t>(rotations))};
  };
  const std::vector<std::size_t> starts = shuffled(cells, draws);
  std::vector<std::size_t> goals = shuffled(cells, draws);
  std::vector<std::pair<Placement, Placement>> moved;
  std::vector<Placement> still;
  for (std::size_t i = 0; i < obstacles; ++i) {
    still.push_back(place(starts[targets + i]));
    std::erase(goals, starts[targets + i]);
  }
  for (std::size_t i = 0; i < targets; ++i) moved.emplace_back(place(starts[i]), place(goals[i]));
  return jointGrid(columns, rows, rotations, moved, still);
}

JointWorld randomJointWorld(std::uint64_t seed) {
  const SymbolicModel model = randomModel(seed);
  JointWorld world = drawnJointGrid(3, 2, 2, 2, seed % 2, seed);
  world.model = model;
  return world;
}

JointWorld dyerWorld(std::uint64_t seed) {
  const ConceptCardinality cardinality{2, 3, 2, 1, 2, 1};
  const GridWorld grid = gridWorld(3, 2, 1, 0, 1);
  const SymbolId dyer{1};
  EffectTable effects;
  LegalityTable legality;
  for (const Action action : kActions) {
    legality[index(action)] = grid.model.legality.factors(action);
    for (const Concept which : {Concept::kPositionX, Concept::kPositionY}) {
      effects[index(action)][index(which)] = grid.model.transitions.effect(action, which);
    }
  }
  const ContextFeature offset{ContextKind::kNearestOffset, Concept::kType, dyer};
  LegalityFactor beside{offset, std::vector<double>(valueCount(offset, cardinality), 0)};
  for (const auto& [dx, dy] :
       {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}}) {
    const int axis = 2 * kOffsetReach + 1;
    beside.share[static_cast<std::size_t>((dy + kOffsetReach) * axis + dx + kOffsetReach)] = 0.3;
  }
  legality[index(Action::kChangeColor)] = {beside};
  effects[index(Action::kChangeColor)][index(Concept::kColor)] = {
      {{ContextKind::kNearestSymbol, Concept::kColor, dyer}},
      {{0, {0.9, 0.1}}, {1, {0.2, 0.8}}},
      1};

  SymbolGrounding grounding = grid.model.grounding;
  grounding.footprints = uniformFootprints(cardinality, {outlineOfDisc(0.05), 0.1});
  RandomStream draws({seed, 29});
  const std::vector<std::size_t> starts = shuffled(6, draws);
  std::vector<std::size_t> goals = shuffled(6, draws);
  std::erase(goals, starts[2]);
  const auto object = [&](std::size_t cell, bool dyes) {
    Symbols symbols = placed({cell % 3, cell / 3, 0});
    symbols[index(Concept::kType)] = dyes ? dyer : SymbolId{0};
    symbols[index(Concept::kColor)] = static_cast<SymbolId>(draws.below(2));
    return certain(symbols, cardinality);
  };
  JointProblem problem;
  problem.workbench.columns = 3;
  problem.workbench.rows = 2;
  problem.objects = {object(starts[0], false), object(starts[1], true),
                     object(starts[2], seed % 2 == 0)};
  problem.targets = {{0, object(goals[0], false)}, {1, object(goals[1], true)}};
  return {{grounding, TransitionModel(cardinality, effects), ActionLegality(cardinality, legality),
           ModelEvidence{}},
          problem};
}

JointWorld learnedJointWorld(const Task& task) {
  const Relabelling& names = learnedRelabelling();
  const SymbolicProblem first = names.problem(task);
  JointWorld world{
      learnedModel(),
      {first.initial.workbench, first.initial.objects, {{first.initial.target, first.goal}}}};
  for (const FurtherTarget& target : task.further) {
    world.problem.targets.push_back(
        {target.object, certain(names.symbols(target.goal), kConceptCardinality)});
  }
  return world;
}

std::optional<LeastCost> leastJointCost(const JointWorld& world, std::size_t most_steps,
                                        double legality_threshold, double step_discount,
                                        bool count_actions) {
  const StepOracle oracle(world, legality_threshold, step_discount, count_actions);
  std::map<Scene, double> reached{{oracle.start(), 0}};  // in exactly `steps` steps
  std::optional<LeastCost> least;
  for (std::size_t steps = 0; steps <= most_steps; ++steps) {
    std::map<Scene, double> next;
    for (const auto& [scene, cost] : reached) {
      if (oracle.isGoal(scene) && (!least || cost < least->cost - 1e-9)) least = {cost, steps};
      if (least && cost > least->cost) continue;
      for (const SceneStep& step : oracle.steps(scene)) {
        const auto [entry, is_new] = next.try_emplace(step.scene, cost + step.cost);
        if (!is_new) entry->second = std::min(entry->second, cost + step.cost);
      }
    }
    reached = std::move(next);
  }
  return least;
}

std::vector<double> allJointCosts(const JointWorld& world, std::size_t most_steps,
                                  double legality_threshold, double step_discount) {
  const StepOracle oracle(world, legality_threshold, step_discount, false);
  using Sequences = std::vector<ActionSequence>;  // [targets]
  std::map<Sequences, double> least;
  const auto extend = [&](const auto& self, const Scene& scene, const Sequences& sequences,
                          double cost, std::size_t steps) -> void {
    if (oracle.isGoal(scene)) {
      const auto [entry, is_new] = least.try_emplace(sequences, cost);
      if (!is_new) entry->second = std::min(entry->second, cost);
    }
    if (steps == most_steps) return;
    for (const SceneStep& step : oracle.steps(scene)) {
      Sequences longer = sequences;
      longer[step.target].push_back(step.action);
      self(self, step.scene, longer, cost + step.cost, steps + 1);
    }
  };
  extend(extend, oracle.start(), Sequences(world.problem.targets.size()), 0, 0);
  std::vector<double> costs;
  for (const auto& [sequences, cost] : least) costs.push_back(cost);
  std::sort(costs.begin(), costs.end());
  return costs;
}

}  // namespace conceptplan::testing
