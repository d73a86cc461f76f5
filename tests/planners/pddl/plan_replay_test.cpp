#include "conceptplan/planners/pddl/plan_replay.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "conceptplan/planners/best_first_planner.hpp"
#include "planners/random_world.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using testing::tinySymbols;

SymbolGraph tinyGraph(const Symbols& start, const Symbols& goal,
                      const std::vector<Symbols>& others = {}) {
  SymbolicProblem problem = testing::tinyProblem(start, goal);
  for (const Symbols& other : others) {
    problem.initial.objects.push_back(certain(other, testing::kTinyCardinality));
  }
  return compile(testing::tinyModel(), problem, GridValidity());
}

PlanReplay replayText(const SymbolGraph& graph, const std::string& text,
                      const Determinisation& determinisation = {}) {
  return replay(graph, parsePlanFile(text, "plan").steps, determinisation);
}

TEST(PlanReplay, TellsCostProbabilityAndStates) {
  const SymbolGraph graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0));
  const PlanReplay replayed = replayText(graph, "(move_right)\n(rotate_left)\n(move_right)\n");
  EXPECT_FALSE(replayed.failure);
  EXPECT_EQ(replayed.cost, 233'194 + 115'411 + 233'194);
  EXPECT_NEAR(replayed.probability, 0.8 * 0.9 * 0.8, 1e-12);
  EXPECT_THAT(replayed.states, ::testing::ElementsAre(graph.state(tinySymbols(0, 1, 0, 0)),
                                                      graph.state(tinySymbols(0, 1, 1, 0)),
                                                      graph.state(tinySymbols(0, 2, 1, 0))));
}

TEST(PlanReplay, NamesTheFirstStepThatIsNotLegal) {
  const SymbolGraph graph = tinyGraph(tinySymbols(0, 1, 0, 0), tinySymbols(0, 2, 1, 0));
  const PlanReplay replayed = replayText(graph, "(move_right)\n(move_right)\n(rotate_left)\n");
  ASSERT_TRUE(replayed.failure);
  EXPECT_EQ(replayed.failure->step, 1u);
  EXPECT_EQ(replayed.failure->reason,
            "the action is not legal: its probability given the symbols is 0.001, not above 0.01");
  EXPECT_EQ(replayed.states.size(), 1u);
  EXPECT_EQ(replayed.cost, 233'194);
  Determinisation lenient;
  lenient.legality_threshold = 0.0001;
  EXPECT_NE(replayText(graph, "(move_right)\n(move_right)\n", lenient).failure->reason,
            replayed.failure->reason);
}

TEST(PlanReplay, NamesTheObjectThatIsMet) {
  const SymbolGraph graph =
      tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 0, 0), {tinySymbols(0, 1, 0, 0)});
  const PlanReplay replayed = replayText(graph, "(move_right)\n");
  ASSERT_TRUE(replayed.failure);
  EXPECT_EQ(replayed.failure->step, 0u);
  EXPECT_EQ(replayed.failure->reason, "its most probable outcome meets object 1");
  EXPECT_EQ(replayed.failure->object, 1u);
  const std::vector<std::string> names{"Cup 1", "Pot 4"};
  EXPECT_EQ(explanation(*replayed.failure, names), "its most probable outcome meets Pot 4");
}

TEST(PlanReplay, ComparesTheArguments) {
  const SymbolGraph graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 1, 0, 0));
  EXPECT_FALSE(replayText(graph, "(move_right position_x-0 position_x-1)").failure);
  EXPECT_EQ(replayText(graph, "(move_right position_x-0 position_x-2)").failure->reason,
            "argument 2 is position_x-2, expected position_x-1");
  EXPECT_EQ(replayText(graph, "(move_right position_x-0)").failure->reason,
            "it has 1 arguments, expected 2");
}

TEST(PlanReplay, TellsInWhatTheEndDiffersFromTheGoal) {
  const SymbolGraph graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0));
  const PlanReplay replayed = replayText(graph, "(move_right)\n");
  ASSERT_TRUE(replayed.failure);
  EXPECT_EQ(replayed.failure->step, 1u);
  EXPECT_EQ(replayed.failure->reason,
            "the goal is not reached: POSITION_X 1 in place of 2, ROTATION 0 in place of 1");
  const SymbolGraph dyed = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 0, 0, 1));
  EXPECT_THAT(replayText(dyed, "").failure->reason, HasSubstr("COLOR must change"));
}

TEST(PlanReplay, AStepThatChangesNothingIsAllowed) {
  const SymbolGraph graph =
      tinyGraph(tinySymbols(0, 1, 0, 1), tinySymbols(0, 1, 0, 1), {tinySymbols(1, 2, 0, 1)});
  const PlanReplay replayed = replayText(graph, "(change_color)\n");
  EXPECT_FALSE(replayed.failure) << replayed.failure->reason;
  EXPECT_EQ(replayed.states.size(), 1u);
}

TEST(GroundPlan, PlansOfThePlannerReplayWithTheirCost) {
  const BestFirstPlanner planner;
  int plans = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const SymbolGraph graph = testing::randomWorld(seed);
    for (const Plan& found : planner.solve(graph, {}).plans) {
      Determinisation exact;
      exact.cost_per_nat = 1'000'000'000;
      const PlanFile plan = groundPlan(graph, found.actions, exact);
      EXPECT_EQ(plan.cost, std::llround(found.cost * 1e9));
      const PlanFile read = parsePlanFile(planFileText(plan), "plan");
      const PlanReplay replayed = replay(graph, read.steps, exact);
      EXPECT_FALSE(replayed.failure);
      EXPECT_EQ(replayed.cost, plan.cost);
      ++plans;
    }
  }
  EXPECT_GT(plans, 50);
}

TEST(GroundPlan, RefusesWhatDoesNotReplay) {
  const SymbolGraph graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 0, 0));
  EXPECT_THAT(
      [&] {
        groundPlan(graph, {Action::kMoveRight, Action::kChangeColor});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr("step 2: ")));
}

}  // namespace
}  // namespace conceptplan
