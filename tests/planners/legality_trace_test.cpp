#include "legality_trace.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "conceptplan/planners/graph_source.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "planners/grid_world.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Symbols at(int x, int y, int rotation = 0) {
  return {SymbolId{0}, SymbolId{x}, SymbolId{y}, SymbolId{rotation}, SymbolId{0}, SymbolId{0}};
}

/// A bench of 3 x 5 cells; the target is the object of that number.
SymbolicProblem problemOf(const std::vector<Symbols>& objects, std::size_t target,
                          const Symbols& goal) {
  const ConceptCardinality cardinality{1, 3, 5, 4, 1, 1};
  SymbolicProblem problem;
  for (const Symbols& object : objects) {
    problem.initial.objects.push_back(certain(object, cardinality));
  }
  problem.initial.target = target;
  problem.goal = certain(goal, cardinality);
  return problem;
}

/// The answers of planners that find out by beliefs, by paths and by a policy.
std::vector<PlanResult> solveAll(const SymbolicProblem& problem, std::size_t horizon = 24) {
  const SymbolicModel model = testing::gridWorld(3, 5, 4, 0, 1).model;
  const GridValidity validity;
  const SymbolGraph graph = compile(model, problem, validity);
  const GraphSource source{model, validity};
  PlanQuery query;
  query.limits.horizon = horizon;
  query.source = &source;
  std::vector<PlanResult> results;
  for (const char* planner : {"belief", "astar", "value-iteration"}) {
    results.push_back(PlannerRegistry::standard().make(planner)->solve(graph, query));
  }
  return results;
}

/// The target, object 2, in a corner behind objects 1 and 3; object 0 stands apart.
const std::vector<Symbols> kLockedIn{at(2, 2), at(1, 0), at(0, 0), at(0, 1)};

TEST(InfeasibleTrace, NamesTheFewestObjectsWithoutWhichThereIsAWay) {
  for (const PlanResult& result : solveAll(problemOf(kLockedIn, 2, at(2, 4)))) {
    ASSERT_EQ(result.status, PlanStatus::kInfeasible);
    // Object 1 alone or object 3 alone would do; the first counts.
    EXPECT_THAT(result.blocking, ElementsAre(1));
    EXPECT_THAT(explanation(result), HasSubstr("; without object 1 there would be a way"));
  }
}

TEST(InfeasibleTrace, NamesSeveralObjectsWhereOneIsNotEnough) {
  std::vector<Symbols> objects = kLockedIn;
  objects[0] = at(1, 4);
  objects.push_back(at(2, 3));
  for (const PlanResult& result : solveAll(problemOf(objects, 2, at(2, 4)))) {
    ASSERT_EQ(result.status, PlanStatus::kInfeasible);
    // Objects 0 and 4 shut the goal in, 1 and 3 the target: one of each must go.
    EXPECT_THAT(result.blocking, ElementsAre(0, 1));
    EXPECT_THAT(explanation(result),
                HasSubstr("; without object 0 and object 1 there would be a way"));
    const std::vector<std::string> names{"Cup 1", "Pot 2", "Egg 3", "Fig 4", "Pan 5"};
    EXPECT_THAT(explanation(result, names),
                HasSubstr("; without Cup 1 and Pot 2 there would be a way"));
  }
}

TEST(InfeasibleTrace, TellsHowNearTheTargetGets) {
  for (const PlanResult& result : solveAll(problemOf(kLockedIn, 2, at(2, 4, 1)))) {
    EXPECT_THAT(result.nearest, ElementsAre(at(0, 0, 1)));
    EXPECT_THAT(result.reason,
                HasSubstr("differs from the goal at least in POSITION_X and POSITION_Y"));
  }
}

TEST(InfeasibleTrace, AnObjectInTheGoalsCellIsTheReason) {
  for (const PlanResult& result : solveAll(problemOf({at(0, 0), at(2, 4)}, 0, at(2, 4)))) {
    EXPECT_THAT(result.blocking, ElementsAre(1));
  }
}

TEST(InfeasibleTrace, AHorizonTooShortIsNoObjectsFault) {
  for (const PlanResult& result : solveAll(problemOf({at(0, 0)}, 0, at(2, 4, 1)), 3)) {
    ASSERT_EQ(result.status, PlanStatus::kInfeasible);
    EXPECT_THAT(result.blocking, IsEmpty());
    EXPECT_THAT(result.reason, HasSubstr("within 3 actions; it takes at least 7"));
  }
}

TEST(InfeasibleTrace, APlanHasNoSuchReason) {
  std::vector<Symbols> objects = kLockedIn;
  objects[1] = at(0, 4);
  for (const PlanResult& result : solveAll(problemOf(objects, 2, at(2, 4)))) {
    ASSERT_EQ(result.status, PlanStatus::kSolved);
    EXPECT_THAT(result.blocking, IsEmpty());
    EXPECT_THAT(result.nearest, IsEmpty());
    EXPECT_EQ(explanation(result), result.reason);
  }
}

/// A planner that looks at all that the locked in target can do: four turns in one cell.
class RejectionTallies : public ::testing::TestWithParam<const char*> {
 protected:
  static PlanResult solve(const SymbolicProblem& problem, bool count) {
    const SymbolGraph graph =
        compile(testing::gridWorld(3, 5, 4, 0, 1).model, problem, GridValidity());
    PlanQuery query;
    query.count_rejections = count;
    return PlannerRegistry::standard().make(GetParam())->solve(graph, query);
  }
};

TEST_P(RejectionTallies, CountEveryStepRuledOutInWhatWasExpandedByCauseAndObject) {
  const SymbolicProblem problem = problemOf(kLockedIn, 2, at(2, 4));
  const PlanResult result = solve(problem, true);
  ASSERT_TRUE(result.ruled_out);
  EXPECT_EQ(result.ruled_out->states, 4u);
  // The rejections around the start are the same here, listed one by one.
  std::size_t steps = 0;
  for (const RejectionCount& count : result.ruled_out->counts) {
    steps += count.steps;
    EXPECT_EQ(count.steps,
              std::ranges::count_if(result.rejections, [&](const Rejection& rejection) {
                return rejection.cause == count.cause && rejection.object == count.object &&
                       rejection.value >= count.least && rejection.value <= count.greatest;
              }));
    if (count.object) {
      EXPECT_EQ(count.steps, 4u);
    }
  }
  EXPECT_EQ(steps, result.rejections.size());
  std::vector<std::optional<std::size_t>> objects;
  for (const RejectionCount& count : result.ruled_out->counts) {
    if (count.cause == Invalidity::kCollision) objects.push_back(count.object);
  }
  EXPECT_THAT(objects, ElementsAre(1, 3));
}

TEST_P(RejectionTallies, AreMadeOnlyWhereTheyAreAskedFor) {
  const SymbolicProblem problem = problemOf(kLockedIn, 2, at(2, 4));
  PlanResult counted = solve(problem, true);
  counted.ruled_out.reset();
  EXPECT_EQ(counted, solve(problem, false));
}

INSTANTIATE_TEST_SUITE_P(Planners, RejectionTallies,
                         ::testing::Values("belief", "bfs", "dijkstra", "kbest", "value-iteration"),
                         [](const auto& planner) {
                           std::string name = planner.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace conceptplan
