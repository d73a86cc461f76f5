// The objects that are said to block the way of one target: without them, and not without fewer,
// the problem compiled again has a way.
#include "graph_blocking.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <tuple>
#include <vector>

#include "conceptplan/domain/simulation/random_stream.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "legality_trace.hpp"
#include "planners/grid_world.hpp"
#include "planners/learned_world.hpp"
#include "planners/sample_tasks.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double kThreshold = 0.01;

/// A cell.
struct Place {
  std::size_t x = 0;
  std::size_t y = 0;
};

/// Object 0 is to go from its place to the goal among the others.
SymbolicProblem problemOf(const SymbolicModel& model, Place goal,
                          const std::vector<Place>& objects) {
  const auto at = [&](Place place) {
    Symbols symbols{};
    symbols[index(Concept::kPositionX)] = static_cast<SymbolId>(place.x);
    symbols[index(Concept::kPositionY)] = static_cast<SymbolId>(place.y);
    return certain(symbols, model.cardinality());
  };
  SymbolicProblem problem;
  problem.initial.workbench.columns = static_cast<int>(model.grounding.columns.size());
  problem.initial.workbench.rows = static_cast<int>(model.grounding.rows.size());
  for (const Place place : objects) problem.initial.objects.push_back(at(place));
  problem.goal = at(goal);
  return problem;
}

PlanResult solved(const SymbolicModel& model, const SymbolicProblem& problem,
                  const std::string& planner = "astar", PlanQuery query = {},
                  const StateValidity& again = GridValidity()) {
  const GraphSource source{model, again};
  query.source = &source;
  const SymbolGraph graph = compile(model, problem, GridValidity());
  return PlannerRegistry::standard().make(planner)->solve(graph, query);
}

/// The problem without the objects whose bits are set; the target is not among them.
SymbolicProblem without(const SymbolicProblem& problem, std::size_t removed) {
  SymbolicProblem rest = problem;
  rest.initial.objects.clear();
  for (std::size_t i = 0; i < problem.initial.objects.size(); ++i) {
    if ((removed >> i & 1) != 0) continue;
    if (i == problem.initial.target) rest.initial.target = rest.initial.objects.size();
    rest.initial.objects.push_back(problem.initial.objects[i]);
  }
  return rest;
}

/// What is blocking by trying without each set of objects, the smallest and lowest first.
SceneObjects byTryingAll(const SymbolicModel& model, const SymbolicProblem& problem) {
  SceneObjects best;
  const std::size_t count = problem.initial.objects.size();
  for (std::size_t removed = 1; removed < std::size_t{1} << count; ++removed) {
    if ((removed >> problem.initial.target & 1) != 0) continue;
    SceneObjects objects;
    for (std::size_t i = 0; i < count; ++i) {
      if ((removed >> i & 1) != 0) objects.push_back(i);
    }
    const bool is_better = best.empty() || objects.size() < best.size() ||
                           (objects.size() == best.size() && objects < best);
    if (!is_better) continue;
    const SymbolGraph graph = compile(model, without(problem, removed), GridValidity());
    SearchGuard guard(SearchLimits{});
    if (frozenMismatch(graph).empty() &&
        isInReach(graph, graph.mostProbableStart(), graph.mostProbableGoal(), kThreshold,
                  graph.numStates(), guard)) {
      best = objects;
    }
  }
  return best;
}

TEST(BlockingObjects, OfACellWithTwoObjectsAreBoth) {
  const SymbolicModel model = testing::gridWorld(3, 5, 4, 0, 1).model;
  const SymbolicProblem problem =
      problemOf(model, {2, 4}, {{0, 0}, {1, 0}, {1, 0}, {0, 1}, {0, 1}});
  for (const char* planner : {"belief", "astar", "value-iteration"}) {
    const PlanResult result = solved(model, problem, planner);
    ASSERT_EQ(result.status, PlanStatus::kInfeasible);
    EXPECT_THAT(result.blocking, ElementsAre(1, 2));
    EXPECT_EQ(solved(model, without(problem, 0b00110), planner).status, PlanStatus::kSolved);
    EXPECT_EQ(solved(model, without(problem, 0b00010), planner).status, PlanStatus::kInfeasible);
  }
}

/// Moves are also legal only where nothing stands in the cell that they lead to.
SymbolicModel watchingModel(int columns, int rows) {
  const SymbolicModel grid = testing::gridWorld(columns, rows, 1, 0, 1).model;
  LegalityTable legality;
  const ContextFeature offset{ContextKind::kNearestOffset, Concept::kType, SymbolId{0}};
  for (const Action action : kActions) legality[index(action)] = grid.legality.factors(action);
  for (const auto& [action, dx, dy] :
       {std::tuple{Action::kMoveRight, 1, 0}, std::tuple{Action::kMoveLeft, -1, 0},
        std::tuple{Action::kMoveFront, 0, 1}, std::tuple{Action::kMoveBack, 0, -1}}) {
    LegalityFactor factor{offset, std::vector<double>(valueCount(offset, grid.cardinality()), 0.2)};
    const int value = (dy + kOffsetReach) * (2 * kOffsetReach + 1) + dx + kOffsetReach;
    factor.share[static_cast<std::size_t>(value)] = 0;
    legality[index(action)].push_back(std::move(factor));
  }
  return {grid.grounding, grid.transitions, ActionLegality(grid.cardinality(), legality),
          ModelEvidence{}};
}

TEST(BlockingObjects, AreThoseThatLegalityWatchesToo) {
  const SymbolicModel model = watchingModel(3, 5);
  const SymbolicProblem problem = problemOf(model, {2, 4}, {{0, 0}, {2, 4}, {2, 0}});
  for (const char* planner : {"belief", "astar", "value-iteration"}) {
    const PlanResult result = solved(model, problem, planner);
    ASSERT_EQ(result.status, PlanStatus::kInfeasible);
    EXPECT_THAT(result.blocking, ElementsAre(1));
    EXPECT_EQ(solved(model, without(problem, 0b010), planner).status, PlanStatus::kSolved);
  }
}

TEST(BlockingObjects, AreNotThoseThatAnActionNeeds) {
  // The dyer is in the way of the target, which cannot become its colour without it.
  SymbolicProblem problem =
      testing::tinyProblem(testing::tinySymbols(0, 0, 0, 0), testing::tinySymbols(0, 2, 0, 1));
  problem.initial.objects.push_back(
      certain(testing::tinySymbols(1, 1, 0, 1), testing::kTinyCardinality));
  const PlanResult result = solved(testing::tinyModel(), problem);
  ASSERT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.blocking, IsEmpty());
  EXPECT_THAT(result.reason, Not(HasSubstr("not known")));
  problem.goal = certain(testing::tinySymbols(0, 2, 0, 0), testing::kTinyCardinality);
  EXPECT_THAT(solved(testing::tinyModel(), problem).blocking, ElementsAre(1));
}

TEST(BlockingObjects, EqualTheSmallestSetOfAllThatCanBeRemoved) {
  std::size_t several = 0, none = 0;
  for (const bool watches : {false, true}) {
    const SymbolicModel model =
        watches ? watchingModel(3, 3) : testing::gridWorld(3, 3, 1, 0, 1).model;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      RandomStream draws({seed, 71});
      const auto place = [&] { return Place{draws.below(3), draws.below(3)}; };
      std::vector<Place> objects{{0, 0}};
      while (objects.size() < 7) {
        const Place other = place();
        if (other.x + other.y > 0) objects.push_back(other);
      }
      const SymbolicProblem problem = problemOf(model, {2, 2}, objects);
      const PlanResult result = solved(model, problem);
      if (result.status != PlanStatus::kInfeasible) continue;
      EXPECT_EQ(result.blocking, byTryingAll(model, problem)) << watches << ' ' << seed;
      several += result.blocking.size() > 1 ? 1 : 0;
    }
  }
  EXPECT_GT(several, 50u);
  const SymbolicModel& model = testing::learnedModel();
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomStream draws({seed, 72});
    Task task = testing::testTask(4, static_cast<int>(seed));
    task.goal.cell = task.initial.objects[draws.below(task.initial.objects.size())].cell;
    if (task.goal.cell == task.initial.objects[task.initial.target].cell) continue;
    const SymbolicProblem problem = testing::learnedRelabelling().problem(task);
    const PlanResult result = solved(model, problem);
    if (result.status != PlanStatus::kInfeasible) continue;
    EXPECT_EQ(result.blocking, byTryingAll(model, problem)) << task.id;
    none += result.blocking.empty() ? 1 : 0;
  }
  EXPECT_GT(none, 5u);
}

/// A bench on which an object stands in every cell but those around the corner where the target is.
std::vector<Place> allButACorner(std::size_t edge, std::size_t in_each_cell) {
  std::vector<Place> objects{{0, 0}};
  for (std::size_t cell = 0; cell < edge * edge; ++cell) {
    const Place place{cell % edge, cell / edge};
    if (place.x + place.y > 1) objects.insert(objects.end(), in_each_cell, place);
  }
  return objects;
}

TEST(BlockingObjects, HaveAnyNumber) {
  const SymbolicModel model = testing::gridWorld(20, 20, 4, 0, 1).model;
  std::vector<Place> objects = allButACorner(20, 1);
  ASSERT_GT(objects.size(), 390u);
  const auto at = [&](std::size_t x, std::size_t y) {
    return static_cast<std::size_t>(
        std::ranges::find_if(objects, [&](Place place) { return place.x == x && place.y == y; }) -
        objects.begin());
  };
  EXPECT_THAT(solved(model, problemOf(model, {2, 0}, objects)).blocking, ElementsAre(at(2, 0)));
  EXPECT_THAT(solved(model, problemOf(model, {0, 3}, objects)).blocking,
              ElementsAre(at(0, 2), at(0, 3)));
  // From the last to the first of 398 objects is no way without the others.
  std::reverse(objects.begin() + 1, objects.end());
  EXPECT_THAT(solved(model, problemOf(model, {2, 0}, objects)).blocking, ElementsAre(at(2, 0)));
}

TEST(BlockingObjects, AreSaidNotToBeKnownWhereThereAreTooManyToTryWithout) {
  const SymbolicModel model = testing::gridWorld(20, 20, 1, 0, 1).model;
  const PlanResult result = solved(model, problemOf(model, {19, 19}, allButACorner(20, 1)));
  ASSERT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.blocking, IsEmpty());
  EXPECT_THAT(result.reason, HasSubstr("; which objects block the way is not known: there are too "
                                       "many to try without"));
  EXPECT_THAT(result.nearest, Not(IsEmpty()));
}

TEST(BlockingObjects, AreNotLookedForWhereNoneAreToBlame) {
  // The only way to turn is not there, and many objects are met.
  SymbolicModel model = testing::gridWorld(20, 20, 4, 0, 1).model;
  LegalityTable legality;
  for (const Action action : kActions) legality[index(action)] = model.legality.factors(action);
  for (const Action action : {Action::kRotateLeft, Action::kRotateRight}) {
    legality[index(action)] = {
        {{ContextKind::kOwnSymbol, Concept::kType, SymbolId{0}}, std::vector<double>{0}}};
  }
  model.legality = ActionLegality(model.cardinality(), legality);
  SymbolicProblem problem = problemOf(model, {19, 19}, allButACorner(20, 1));
  problem.goal[index(Concept::kRotation)] = {0, 1, 0, 0};
  const PlanResult result = solved(model, problem);
  ASSERT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.blocking, IsEmpty());
  EXPECT_THAT(result.reason, Not(HasSubstr("not known")));
}

TEST(BlockingObjects, AreNotToldWithoutWhatTheGraphWasCompiledFrom) {
  const SymbolicModel model = testing::gridWorld(3, 5, 4, 0, 1).model;
  const SymbolGraph graph =
      compile(model, problemOf(model, {2, 4}, {{0, 0}, {1, 0}, {0, 1}}), GridValidity());
  const PlanResult result = PlannerRegistry::standard().make("astar")->solve(graph, {});
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.blocking, IsEmpty());
}

TEST(BlockingObjects, TellThatTheWayWithoutThemIsBeyondTheHorizon) {
  const SymbolicModel model = testing::gridWorld(3, 5, 1, 0, 1).model;
  const SymbolicProblem problem = problemOf(model, {2, 4}, {{0, 0}, {1, 0}, {0, 1}});
  PlanQuery query;
  query.limits.horizon = 5;
  const PlanResult result = solved(model, problem, "astar", query);
  EXPECT_THAT(result.blocking, ElementsAre(1));
  EXPECT_THAT(result.reason, HasSubstr("; a way without what blocks it has 6 actions"));
  query.limits.horizon = 6;
  EXPECT_THAT(solved(model, problem, "astar", query).reason, Not(HasSubstr("a way without")));
}

/// Cancels the search when it is asked.
class CancellingValidity final : public StateValidity {
 public:
  Verdict check(const Workbench&, const SymbolGrounding&, const Symbols&,
                std::span<const Symbols>) const override {
    cancel = true;
    return {};
  }
  std::array<bool, kNumConcepts> dependsOn() const override { return GridValidity().dependsOn(); }

  mutable std::atomic<bool> cancel{false};
};

TEST(BlockingObjects, AreSaidNotToBeKnownAfterACancel) {
  const SymbolicModel model = testing::gridWorld(40, 40, 1, 0, 1).model;
  const SymbolicProblem problem = problemOf(model, {2, 4}, {{0, 0}, {1, 0}, {0, 1}});
  const CancellingValidity validity;
  PlanQuery query;
  query.limits.cancel = &validity.cancel;
  const PlanResult result = solved(model, problem, "astar", query, validity);
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.blocking, IsEmpty());
  EXPECT_THAT(result.reason, HasSubstr("; which objects block the way is not known: cancelled"));
}

TEST(BlockingObjects, CostValidityChecksThatAreCounted) {
  const SymbolicModel model = testing::gridWorld(3, 5, 1, 0, 1).model;
  const SymbolicProblem problem = problemOf(model, {2, 4}, {{0, 0}, {1, 0}, {0, 1}});
  // The problem, then without both objects, then without the first.
  EXPECT_EQ(solved(model, problem).statistics.validity_checks, 3u * 15u);
}

}  // namespace
}  // namespace conceptplan
