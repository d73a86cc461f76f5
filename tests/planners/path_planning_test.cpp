#include "conceptplan/planners/path_planning.hpp"

#include <gmock/gmock.h>

#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::tinyModel;
using testing::tinyProblem;
using testing::tinySymbols;

constexpr double kLegal = 0.01;

SymbolGraph graphTo(const Symbols& goal) {
  return compile(tinyModel(), tinyProblem(tinySymbols(0, 0, 0, 0), goal), GridValidity());
}

PlanResult answer(const SymbolGraph& graph, const PathFinder& paths) {
  return planByPaths(graph, PlanQuery{}, kLegal, paths);
}

TEST(PathPlanning, APathBecomesAPlanWithItsProbabilityAndPredictedSymbols) {
  const SymbolGraph graph = graphTo(tinySymbols(0, 1, 0, 0));
  const PlanResult result = answer(graph, [&](const PathTask& task) {
    EXPECT_EQ(graph.symbols(task.start), tinySymbols(0, 0, 0, 0));
    EXPECT_EQ(graph.symbols(task.goal), tinySymbols(0, 1, 0, 0));
    StatePath path;
    path.actions = {Action::kMoveRight};
    path.states = {task.goal};
    path.cost = toPathCost(0.5);
    return std::vector{path};
  });
  EXPECT_EQ(result.status, PlanStatus::kSolved);
  ASSERT_EQ(result.plans.size(), 1u);
  EXPECT_THAT(result.plans[0].actions, ElementsAre(Action::kMoveRight));
  EXPECT_THAT(result.plans[0].predicted, ElementsAre(tinySymbols(0, 1, 0, 0)));
  EXPECT_NEAR(result.plans[0].probability, 0.8, 1e-12);
  EXPECT_EQ(result.plans[0].cost, 0.5);
}

TEST(PathPlanning, NoPathProvesThatThereIsNone) {
  const PlanResult result = answer(graphTo(tinySymbols(0, 2, 0, 0)),
                                   [](const PathTask&) { return std::vector<StatePath>(); });
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.reason, HasSubstr("within 24 actions"));
  EXPECT_FALSE(result.rejections.empty());
}

TEST(PathPlanning, NoPathAfterTheGuardStoppedIsGivingUp) {
  const PlanResult result = answer(graphTo(tinySymbols(0, 2, 0, 0)), [](const PathTask& task) {
    task.guard.stop(PlanStatus::kLimit, "no idea left");
    return std::vector<StatePath>();
  });
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.reason, "no idea left");
  EXPECT_THAT(result.nearest, IsEmpty());
}

TEST(PathPlanning, WhatNothingHereChangesIsRefusedWithoutASearch) {
  const PlanResult result =
      answer(graphTo(tinySymbols(0, 0, 0, 1)), [](const PathTask&) -> std::vector<StatePath> {
        ADD_FAILURE() << "searched";
        return {};
      });
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_EQ(result.reason, "COLOR must change, and nothing here changes it");
}

TEST(PathPlanning, WhereNothingChangesOneConceptTheNearestIsSoByTheOthers) {
  const PlanResult result = answer(graphTo(tinySymbols(0, 2, 0, 1)),
                                   [](const PathTask&) { return std::vector<StatePath>(); });
  EXPECT_EQ(result.reason, "COLOR must change, and nothing here changes it");
  EXPECT_THAT(result.nearest, ElementsAre(tinySymbols(0, 2, 0, 0)));
  EXPECT_THAT(result.blocking, IsEmpty());
}

}  // namespace
}  // namespace conceptplan
