#include "legality_trace.hpp"

#include <gmock/gmock.h>

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
  const SymbolGraph graph =
      compile(testing::gridWorld(3, 5, 4, 0, 1).model, problem, GridValidity());
  PlanQuery query;
  query.limits.horizon = horizon;
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
    EXPECT_THAT(result.reason, HasSubstr("without object 1 there would be a way"));
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
    EXPECT_THAT(result.reason, HasSubstr("without objects 0 and 1 there would be a way"));
  }
}

TEST(InfeasibleTrace, TellsHowNearTheTargetGets) {
  for (const PlanResult& result : solveAll(problemOf(kLockedIn, 2, at(2, 4, 1)))) {
    EXPECT_EQ(result.nearest, at(0, 0, 1));
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
    EXPECT_FALSE(result.nearest.has_value());
  }
}

}  // namespace
}  // namespace conceptplan
