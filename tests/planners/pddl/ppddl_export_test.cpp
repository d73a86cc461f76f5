#include <gmock/gmock.h>

#include <map>
#include <set>

#include "conceptplan/planners/pddl/pddl_export.hpp"
#include "planners/learned_world.hpp"
#include "planners/pddl/pddl_task.hpp"
#include "planners/pddl/target_facts.hpp"
#include "planners/random_world.hpp"
#include "planners/sample_tasks.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using testing::PddlTask;
using testing::stateOf;
using testing::tinySymbols;

PddlTask taskOf(const SymbolGraph& graph) {
  const PddlText text = toPpddl(graph);
  return {text.domain, text.problem};
}

std::map<StateId, double> outcomesIn(const SymbolGraph& graph, StateId state, Action action) {
  std::map<StateId, double> outcomes;
  for (const Transition& outcome : graph.transitions(state, action)) {
    outcomes[outcome.state] = outcome.probability;
  }
  return outcomes;
}

/// In every state that the text leads to, its actions and their outcomes are those of the graph.
/// @param most states looked at
void expectSameProcess(const SymbolGraph& graph, std::size_t most) {
  const PddlTask task = taskOf(graph);
  const StateId start = graph.mostProbableStart();
  std::set<PddlTask::State> seen{task.initial()};
  std::vector<PddlTask::State> open{task.initial()};
  for (std::size_t i = 0; i < open.size() && i < most; ++i) {
    const StateId state = stateOf(graph, open[i]);
    std::map<std::string, PddlTask::Step> steps;
    for (const PddlTask::Step& step : task.steps(open[i])) {
      const std::string action = step.text.substr(1, step.text.find_first_of(" )") - 1);
      EXPECT_TRUE(steps.emplace(action, step).second) << "ambiguous " << action;
      for (const PddlTask::Outcome& outcome : step.outcomes) {
        if (seen.insert(outcome.state).second) open.push_back(outcome.state);
      }
    }
    for (const Action action : kActions) {
      SCOPED_TRACE(name(action));
      const std::map<StateId, double> expected = outcomesIn(graph, state, action);
      const bool may =
          graph.legality(state, action) > 0.01 && (graph.valid(state) || state == start);
      const auto found = steps.find(std::string(name(action)));
      if (found == steps.end()) {
        EXPECT_TRUE(!may || expected.at(state) > 1 - 1e-9);
        continue;
      }
      EXPECT_TRUE(may);
      double sum = 0;
      for (const PddlTask::Outcome& outcome : found->second.outcomes) {
        const auto right = expected.find(stateOf(graph, outcome.state));
        const double probability = right == expected.end() ? 0 : right->second;
        EXPECT_NEAR(outcome.probability, probability, 1e-8);
        sum += outcome.probability;
      }
      EXPECT_NEAR(sum, 1, 1e-9);
    }
    EXPECT_EQ(task.isGoal(open[i]),
              state == graph.mostProbableGoal() && (graph.valid(state) || state == start));
  }
}

TEST(PpddlExport, RandomWorldsAreTheSameProcess) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = testing::randomWorld(seed);
    if (graph.mutability(Concept::kRotation) == Mutability::kFrozenHere) continue;
    expectSameProcess(graph, 100);
  }
}

TEST(PpddlExport, ALearnedTaskIsTheSameProcess) {
  const SymbolicProblem problem = testing::learnedRelabelling().problem(testing::testTask(4, 2));
  expectSameProcess(compile(testing::learnedModel(), problem, GridValidity()), 30);
}

TEST(PpddlExport, OutcomesStandUnderTheConditionsThatMatter) {
  const SymbolGraph graph = compile(
      testing::tinyModel(), testing::tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0)),
      GridValidity());
  const PddlText text = toPpddl(graph);
  EXPECT_THAT(
      text.domain,
      HasSubstr("(:requirements :strips :typing :conditional-effects :probabilistic-effects)"));
  EXPECT_THAT(text.domain,
              HasSubstr("(when (and (target_position_x position_x-0))\n        (probabilistic 0.8 "
                        "(and (not (target_position_x position_x-0)) (target_position_x "
                        "position_x-1))))"));
  EXPECT_THAT(text.domain, HasSubstr("(when (and (target_rotation rotation-1))\n        "
                                     "(probabilistic 0.9 "));
}

TEST(PpddlExport, AStartThatIsNotValidCanBeLeft) {
  SymbolicProblem problem = testing::tinyProblem(tinySymbols(0, 1, 0, 0), tinySymbols(0, 0, 0, 0));
  problem.initial.objects.push_back(certain(tinySymbols(0, 1, 0, 0), testing::kTinyCardinality));
  const SymbolGraph graph = compile(testing::tinyModel(), problem, GridValidity());
  const PddlTask task = taskOf(graph);
  EXPECT_FALSE(task.steps(task.initial()).empty());
}

}  // namespace
}  // namespace conceptplan
