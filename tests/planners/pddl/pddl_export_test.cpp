#include "conceptplan/planners/pddl/pddl_export.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "conceptplan/planners/best_first_planner.hpp"
#include "conceptplan/planners/pddl/plan_replay.hpp"
#include "planners/grid_world.hpp"
#include "planners/learned_world.hpp"
#include "planners/pddl/pddl_task.hpp"
#include "planners/pddl/target_facts.hpp"
#include "planners/random_world.hpp"
#include "planners/sample_tasks.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::PddlTask;
using testing::randomWorld;
using testing::stateOf;
using testing::tinyModel;
using testing::tinyProblem;
using testing::tinySymbols;

PddlOptions exactCosts() {
  PddlOptions options;
  options.determinisation.cost_per_nat = 1'000'000'000;
  return options;
}

PddlTask taskOf(const SymbolGraph& graph, const PddlOptions& options = {}) {
  const PddlText text = toPddl(graph, options);
  return {text.domain, text.problem};
}

PlanResult bestPlan(const SymbolGraph& graph) {
  PlanQuery query;
  query.top = 1;
  query.limits.horizon = 1000;
  query.limits.max_expansions = 1'000'000;
  return BestFirstPlanner(BestFirstPlannerOptions{.guidance = Guidance::kNone}).solve(graph, query);
}

/// The cheapest plan of the text has the cost of the planner's, to the last unit, and replays.
void expectSameOptimum(const SymbolGraph& graph) {
  const std::optional<PddlTask::Solution> solution = taskOf(graph, exactCosts()).solve();
  const PlanResult result = bestPlan(graph);
  ASSERT_EQ(solution.has_value(), result.status == PlanStatus::kSolved) << result.reason;
  if (!solution) return;
  EXPECT_EQ(solution->cost, std::llround(result.plans.front().cost * 1e9));
  std::string text;
  for (const std::string& step : solution->steps) text += step + "\n";
  const PlanReplay replayed =
      replay(graph, parsePlanFile(text, "plan").steps, exactCosts().determinisation);
  EXPECT_FALSE(replayed.failure) << replayed.failure->reason;
  EXPECT_EQ(replayed.cost, solution->cost);
}

SymbolGraph tinyGraph(const Symbols& start, const Symbols& goal) {
  return compile(tinyModel(), tinyProblem(start, goal), GridValidity());
}

SymbolGraph learnedGraph(int level, int number) {
  const Task task = testing::testTask(level, number);
  return compile(testing::learnedModel(), testing::learnedRelabelling().problem(task),
                 GridValidity());
}

TEST(PddlExport, RandomWorldsHaveTheOptimumOfDijkstra) {
  int solved = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed, seed % 3 == 0);
    expectSameOptimum(graph);
    solved += bestPlan(graph).status == PlanStatus::kSolved ? 1 : 0;
  }
  EXPECT_GT(solved, 30);
  EXPECT_LT(solved, 120);
}

TEST(PddlExport, LearnedTasksOfEveryLevelHaveTheOptimumOfDijkstra) {
  for (int level = 1; level <= 4; ++level) {
    for (int i = 0; i < 5; ++i) {
      SCOPED_TRACE(std::to_string(level) + ", " + std::to_string(i));
      expectSameOptimum(learnedGraph(level, i));
    }
  }
}

TEST(PddlExport, GridsWithObstaclesHaveTheOptimumOfDijkstra) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const testing::GridWorld world = testing::gridWorld(9, 7, 4, 0.3, seed);
    expectSameOptimum(compile(world.model, world.problem, GridValidity()));
  }
}

TEST(PddlExport, StandardCostsAreMillionthsOfANat) {
  const SymbolGraph graph = learnedGraph(4, 7);
  const auto solution = taskOf(graph).solve();
  ASSERT_TRUE(solution);
  const double steps = static_cast<double>(solution->steps.size());
  EXPECT_NEAR(static_cast<double>(solution->cost) / 1e6, bestPlan(graph).plans.front().cost,
              steps * 1e-6);
  EXPECT_GE(static_cast<double>(solution->cost), steps * 10'050);  // -log(0.99) for each
}

TEST(PddlExport, TheTextAllowsExactlyTheLegalAndValidSteps) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed);
    const PddlTask task = taskOf(graph);
    std::set<PddlTask::State> seen{task.initial()};
    std::vector<PddlTask::State> open{task.initial()};
    while (!open.empty()) {
      const PddlTask::State facts = open.back();
      open.pop_back();
      const StateId state = stateOf(graph, facts);
      std::map<std::string, StateId> allowed;
      for (const PddlTask::Step& step : task.steps(facts)) {
        const std::string action = step.text.substr(1, step.text.find_first_of(" )") - 1);
        const PddlTask::State& next = step.outcomes.front().state;
        EXPECT_TRUE(allowed.emplace(action, stateOf(graph, next)).second) << "ambiguous " << action;
        if (seen.insert(next).second) open.push_back(next);
      }
      for (const Action action : kActions) {
        const StateId next = graph.transitions(state, action).front().state;
        const auto found = allowed.find(std::string(name(action)));
        if (graph.legality(state, action) > 0.01 && graph.valid(next) && next != state) {
          ASSERT_NE(found, allowed.end()) << name(action);
        }
        if (found == allowed.end()) continue;
        EXPECT_GT(graph.legality(state, action), 0.01) << name(action);
        EXPECT_TRUE(graph.valid(next)) << name(action);
        EXPECT_EQ(found->second, next) << name(action);
      }
    }
  }
}

TEST(PddlExport, FactsSpeakOfNoMoreConceptsThanTheyDependOn) {
  const PddlText text = toPddl(tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0)));
  EXPECT_THAT(text.domain, HasSubstr("(:requirements :strips :typing :action-costs)"));
  EXPECT_THAT(text.domain, HasSubstr("(:types position_x rotation color)"));
  EXPECT_THAT(text.domain, HasSubstr("(legal_move_right ?position_x - position_x)"));
  EXPECT_THAT(text.domain, HasSubstr("(leads_move_right_position_x ?position_x - position_x "
                                     "?position_x_next - position_x)"));
  EXPECT_THAT(text.domain, Not(HasSubstr("valid")));         // all states are
  EXPECT_THAT(text.domain, Not(HasSubstr("change_color")));  // there is no dyer
  EXPECT_THAT(text.problem, HasSubstr("(legal_move_right position_x-1)"));
  EXPECT_THAT(text.problem, Not(HasSubstr("(legal_move_right position_x-2)")));
  EXPECT_THAT(text.problem, HasSubstr("(leads_move_left_position_x position_x-2 position_x-1)"));
  EXPECT_THAT(text.problem, HasSubstr("(target_rotation rotation-0)"));
  // -log(0.9) - log(0.99) and -log(0.8) - log(0.99), in millionths
  EXPECT_THAT(text.domain, HasSubstr("(increase (total-cost) 115411)"));
  EXPECT_THAT(text.domain, HasSubstr("(increase (total-cost) 233194)"));
}

TEST(PddlExport, AStartThatIsNotValidCanBeLeft) {
  SymbolicProblem problem = tinyProblem(tinySymbols(0, 1, 0, 0), tinySymbols(0, 0, 0, 0));
  problem.initial.objects.push_back(
      certain(tinySymbols(0, 1, 0, 0), testing::kTinyCardinality));  // in the target's cell
  const SymbolGraph graph = compile(tinyModel(), problem, GridValidity());
  ASSERT_FALSE(graph.valid(graph.mostProbableStart()));
  const auto solution = taskOf(graph).solve();
  ASSERT_TRUE(solution);
  EXPECT_EQ(solution->steps.size(), 1u);
  expectSameOptimum(graph);
}

TEST(PddlExport, AConceptThatNothingHereChangesKeepsTheGoalOutOfReach) {
  const SymbolGraph graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 0, 0, 1));
  const PddlTask task = taskOf(graph);
  EXPECT_FALSE(task.isGoal(task.initial()));
  EXPECT_FALSE(task.solve());
  EXPECT_EQ(bestPlan(graph).status, PlanStatus::kInfeasible);
}

TEST(PddlExport, TheLegalityThresholdAndTheStepDiscountCount) {
  const SymbolGraph graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 0, 0));
  PddlOptions strict;
  strict.determinisation.legality_threshold = 0.5;
  EXPECT_FALSE(taskOf(graph, strict).solve());
  PddlOptions free_steps;
  free_steps.determinisation.step_discount = 0;
  EXPECT_EQ(taskOf(graph, free_steps).solve()->cost, 2 * 223'144);  // -log(0.8)
}

TEST(PddlExport, NamesAndCommentsCannotBreakTheText) {
  const SymbolGraph graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 0, 0));
  PddlOptions options;
  options.name = "3 cups) (:goal (and))\n;";
  options.symbol_names[index(Concept::kColor)] = {"red", "green\n(define"};
  EXPECT_EQ(taskOf(graph, options).solve()->steps.size(), 2u);
  const PddlText text = toPddl(graph, options);
  EXPECT_THAT(text.domain, HasSubstr("(define (domain p-3-cups----goal--and----)\n"));
  EXPECT_THAT(text.problem, HasSubstr("; color-0: red\n"));
  options.name = "";
  EXPECT_THAT(toPddl(graph, options).domain, HasSubstr("(domain p-)"));
}

TEST(PddlExport, TheSameGraphGivesTheSameText) {
  const PddlText once = toPddl(learnedGraph(4, 3));
  const PddlText twice = toPddl(learnedGraph(4, 3));
  EXPECT_EQ(once.domain, twice.domain);
  EXPECT_EQ(once.problem, twice.problem);
}

TEST(PddlExport, RefusesOptionsOutOfRange) {
  const SymbolGraph graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 0, 0));
  const auto refused = [&graph](const Determinisation& determinisation, const char* message) {
    PddlOptions options;
    options.determinisation = determinisation;
    EXPECT_THAT([&] { toPddl(graph, options); },
                ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
    EXPECT_THAT([&] { toPpddl(graph, options); },
                ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
  };
  refused({.legality_threshold = 2}, "legality_threshold is 2");
  refused({.step_discount = -1}, "step_discount is -1");
  refused({.cost_per_nat = 0}, "cost_per_nat is 0");
}

}  // namespace
}  // namespace conceptplan
