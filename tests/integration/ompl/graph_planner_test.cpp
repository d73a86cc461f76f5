#include "conceptplan/ompl/graph_planner.hpp"

#include <gmock/gmock.h>
#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/control/SimpleSetup.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/control/spaces/DiscreteControlSpace.h>
#include <ompl/tools/benchmark/Benchmark.h>

#include <map>
#include <sstream>
#include <stdexcept>

#include "conceptplan/ompl/action_space.hpp"
#include "conceptplan/ompl/symbol_space_information.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "integration/ompl/task_graph.hpp"

namespace conceptplan {
namespace {

using ompl::base::PlannerStatus;
using testing::graphOf;
using ::testing::HasSubstr;
using testing::learnedRelabelling;
using testing::lockedInTask;
using testing::testTask;
using ::testing::ThrowsMessage;
using testing::tinyGraph;
using testing::tinySymbols;

using StateType = SymbolStateSpace::StateType;

constexpr double kPatience_s = 100;  // the machine may be busy

/// A planner that ends when it is cancelled, with no plan.
class Waiting final : public Planner {
  PlanResult search(const SymbolGraph&, const PlanQuery& query) const override {
    while (!*query.limits.cancel) {
    }
    PlanResult result;
    result.status = PlanStatus::kLimit;
    return result;
  }
};

/// A row of obstacles divides the bench; start and goal lie before it, two steps apart.
Task dividedTask() {
  Task task = lockedInTask();
  task.initial.objects[1].cell = {0, 2};
  task.initial.objects[2].cell = {1, 2};
  task.initial.objects.push_back({ObjectType::kEgg, {2, 2}, 0, 0, 0});
  task.goal.cell = {2, 0};
  return task;
}

/// The state of the target of `dividedTask` in a cell.
StateType stateAt(const SymbolGraph& graph, int column, int row) {
  ObjectState target = dividedTask().goal;
  target.cell = {column, row};
  return StateType(graph.state(learnedRelabelling().symbols(target)));
}

class GraphPlannerTest : public ::testing::Test {
 protected:
  void SetUp() override { ompl::msg::noOutputHandler(); }
  void TearDown() override { ompl::msg::restorePreviousOutputHandler(); }

  /// A set-up of a graph's problem with one of our planners.
  static std::unique_ptr<ompl::control::SimpleSetup> setupOf(
      std::shared_ptr<const SymbolGraph> graph, const std::string& planner = "bfs") {
    auto setup =
        std::make_unique<ompl::control::SimpleSetup>(makeSpaceInformation(std::move(graph)));
    setStartAndGoal(*setup->getProblemDefinition());
    setup->setPlanner(std::make_shared<GraphPlanner>(
        setup->getSpaceInformation(), PlannerRegistry::standard().make(planner), planner));
    return setup;
  }
};

TEST_F(GraphPlannerTest, OurPlannersSolveTasksOfEveryLevelInSimpleSetup) {
  for (const char* planner : {"belief", "bfs"}) {
    for (int level = 1; level <= 4; ++level) {
      const Task task = testTask(level, 1);
      const auto setup = setupOf(graphOf(task), planner);
      EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::EXACT_SOLUTION) << task.id;
      ASSERT_TRUE(setup->haveExactSolutionPath());
      EXPECT_TRUE(setup->getSolutionPath().check());
      EXPECT_EQ(setup->getSolutionPath().length(), task.reference.size()) << task.id;
      EXPECT_EQ(setup->getPlanner()->getName(), planner);
    }
  }
}

TEST_F(GraphPlannerTest, ThePathHoldsTheActionsOfThePlan) {
  const auto setup = setupOf(tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0)));
  ASSERT_TRUE(setup->solve(kPatience_s));
  ompl::control::PathControl& path = setup->getSolutionPath();
  ASSERT_EQ(path.getControlCount(), 3u);
  ActionSequence actions;
  for (unsigned int i = 0; i < 3; ++i) actions.push_back(*ActionSpace::action(path.getControl(i)));
  EXPECT_EQ(actions, setup->getPlanner()->as<GraphPlanner>()->result().plans.front().actions);
}

TEST_F(GraphPlannerTest, PlansBetweenOtherStatesThanTheGraphWasCompiledFor) {
  const auto graph = tinyGraph(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0));
  const auto setup = setupOf(graph, "belief");
  const StateType start(graph->state(tinySymbols(0, 2, 0, 0)));
  const StateType goal(graph->state(tinySymbols(0, 0, 0, 0)));
  setup->getProblemDefinition()->clearStartStates();
  setup->getProblemDefinition()->setStartAndGoalStates(&start, &goal);
  EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(setup->getSolutionPath().length(), 2);
  EXPECT_TRUE(setup->getSolutionPath().check());
}

TEST_F(GraphPlannerTest, SolvesAgainAfterAClear) {
  const auto setup = setupOf(graphOf(testTask(3, 1)));
  EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::EXACT_SOLUTION);
  const double length = setup->getSolutionPath().length();
  setup->clear();
  EXPECT_FALSE(setup->haveSolutionPath());
  EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(setup->getSolutionPath().length(), length);
}

TEST_F(GraphPlannerTest, AnInfeasibleProblemGetsAProof) {
  const auto setup = setupOf(graphOf(lockedInTask()));
  EXPECT_FALSE(setup->solve(kPatience_s));
  EXPECT_NE(setup->getLastPlannerStatus(), PlannerStatus::TIMEOUT);
  EXPECT_TRUE(setup->getProblemDefinition()->hasSolutionNonExistenceProof());
  EXPECT_EQ(setup->getPlanner()->as<GraphPlanner>()->result().status, PlanStatus::kInfeasible);
}

TEST_F(GraphPlannerTest, EveryStateOfAGoalIsTried) {
  const auto graph = graphOf(dividedTask());
  const StateType beyond = stateAt(*graph, 2, 4), before = stateAt(*graph, 2, 0);
  for (const char* planner : {"belief", "bfs"}) {
    for (const auto& states : {std::vector{&beyond, &before}, std::vector{&before, &beyond}}) {
      const auto setup = setupOf(graph, planner);
      const auto goal = std::make_shared<ompl::base::GoalStates>(setup->getSpaceInformation());
      for (const StateType* state : states) goal->addState(state);
      setup->getProblemDefinition()->setGoal(goal);
      EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::EXACT_SOLUTION);
      EXPECT_EQ(setup->getSolutionPath().length(), 2);
      EXPECT_TRUE(setup->getSolutionPath().check());
      EXPECT_FALSE(setup->getProblemDefinition()->hasSolutionNonExistenceProof());
    }
  }
}

TEST_F(GraphPlannerTest, EveryStartIsTried) {
  const auto graph = graphOf(dividedTask());
  const StateType beyond = stateAt(*graph, 0, 4), before = stateAt(*graph, 1, 0);
  const StateType goal = stateAt(*graph, 2, 0);
  for (const auto& starts : {std::vector{&beyond, &before}, std::vector{&before, &beyond}}) {
    const auto setup = setupOf(graph);
    setup->getProblemDefinition()->clearStartStates();
    for (const StateType* start : starts) setup->getProblemDefinition()->addStartState(start);
    EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(SymbolStateSpace::id(setup->getSolutionPath().getState(0)), before.id);
    EXPECT_FALSE(setup->getProblemDefinition()->hasSolutionNonExistenceProof());
  }
}

TEST_F(GraphPlannerTest, WhatFailsForEveryStartAndGoalIsProved) {
  const auto graph = graphOf(dividedTask());
  const auto setup = setupOf(graph);
  const StateType other_start = stateAt(*graph, 2, 1);
  setup->getProblemDefinition()->addStartState(&other_start);
  const auto goal = std::make_shared<ompl::base::GoalStates>(setup->getSpaceInformation());
  for (const int column : {0, 1, 2}) {
    const StateType beyond = stateAt(*graph, column, 4);
    goal->addState(&beyond);
  }
  setup->getProblemDefinition()->setGoal(goal);
  EXPECT_FALSE(setup->solve(kPatience_s));
  EXPECT_NE(setup->getLastPlannerStatus(), PlannerStatus::TIMEOUT);
  EXPECT_TRUE(setup->getProblemDefinition()->hasSolutionNonExistenceProof());
}

TEST_F(GraphPlannerTest, AGoalHasTheStatesWithinItsThreshold) {
  const auto graph = graphOf(dividedTask());
  const StateType start = stateAt(*graph, 0, 0), goal = stateAt(*graph, 2, 4);
  for (const double threshold : {2.5, 3.5}) {  // three steps to what is in reach
    const auto setup = setupOf(graph);
    setup->getProblemDefinition()->clearStartStates();
    setup->getProblemDefinition()->setStartAndGoalStates(&start, &goal, threshold);
    const bool solved = setup->solve(kPatience_s) == PlannerStatus::EXACT_SOLUTION;
    EXPECT_EQ(solved, threshold > 3);
    EXPECT_EQ(setup->getProblemDefinition()->hasSolutionNonExistenceProof(), !solved);
  }
}

TEST_F(GraphPlannerTest, NothingIsProvedOfAGoalThatIsSampled) {
  const auto graph = graphOf(dividedTask());
  const StateType beyond = stateAt(*graph, 2, 4), before = stateAt(*graph, 2, 0);
  const auto setup = setupOf(graph);
  const auto goal = std::make_shared<ompl::base::GoalLazySamples>(
      setup->getSpaceInformation(),
      [](const ompl::base::GoalLazySamples*, ompl::base::State*) { return false; }, false);
  setup->getProblemDefinition()->setGoal(goal);
  EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::INVALID_GOAL);
  goal->addState(&beyond);
  EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::TIMEOUT);
  EXPECT_FALSE(setup->getProblemDefinition()->hasSolutionNonExistenceProof());
  goal->addState(&before);
  EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::EXACT_SOLUTION);
}

TEST_F(GraphPlannerTest, AHorizonTooNearProvesNothing) {
  const auto setup = setupOf(graphOf(dividedTask()));
  setup->getPlanner()->params().setParam("horizon", "1");
  EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::TIMEOUT);
  EXPECT_EQ(setup->getPlanner()->as<GraphPlanner>()->result().status, PlanStatus::kInfeasible);
  EXPECT_FALSE(setup->getProblemDefinition()->hasSolutionNonExistenceProof());
}

TEST_F(GraphPlannerTest, PathsEndBeforeAMotionThatIsDeniedAndFurtherPlansAreTried) {
  const auto graph = graphOf(dividedTask());
  const StateType denied = stateAt(*graph, 2, 0), on_the_way = stateAt(*graph, 1, 0);
  const auto solve = [&](std::size_t top) {
    SymbolSpaceOptions options;
    options.check_motion = [&](const Symbols& from, const Symbols& to) {
      return graph->state(from) != on_the_way.id || graph->state(to) != denied.id;
    };
    auto setup = std::make_unique<ompl::control::SimpleSetup>(makeSpaceInformation(graph, options));
    setStartAndGoal(*setup->getProblemDefinition());
    setup->setPlanner(std::make_shared<GraphPlanner>(setup->getSpaceInformation(),
                                                     PlannerRegistry::standard().make("bfs"), "bfs",
                                                     PlanQuery{.top = top}));
    setup->solve(kPatience_s);
    return setup;
  };
  const auto one = solve(1);
  EXPECT_EQ(one->getLastPlannerStatus(), PlannerStatus::APPROXIMATE_SOLUTION);
  EXPECT_EQ(SymbolStateSpace::id(one->getSolutionPath().getStates().back()), on_the_way.id);
  EXPECT_TRUE(one->getSolutionPath().check());
  const auto several = solve(20);
  EXPECT_EQ(several->getLastPlannerStatus(), PlannerStatus::EXACT_SOLUTION);
  EXPECT_EQ(several->getSolutionPath().length(), 4);
  EXPECT_TRUE(several->getSolutionPath().check());
}

TEST_F(GraphPlannerTest, TheTerminationConditionCancels) {
  const auto setup = setupOf(graphOf(testTask(4, 0)));
  setup->setPlanner(std::make_shared<GraphPlanner>(setup->getSpaceInformation(),
                                                   std::make_shared<Waiting>(), "waiting"));
  EXPECT_EQ(setup->solve(0.02), PlannerStatus::TIMEOUT);
  EXPECT_FALSE(setup->haveSolutionPath());
  EXPECT_FALSE(setup->getProblemDefinition()->hasSolutionNonExistenceProof());
}

TEST_F(GraphPlannerTest, TheLimitsAreParameters) {
  const auto setup = setupOf(graphOf(testTask(4, 0)));
  setup->getPlanner()->params().setParam("max_expansions", "1");
  EXPECT_EQ(setup->solve(kPatience_s), PlannerStatus::TIMEOUT);
  EXPECT_THAT(setup->getPlanner()->as<GraphPlanner>()->result().reason,
              HasSubstr("limit of 1 expansions"));
}

TEST_F(GraphPlannerTest, RefusesNoPlannerAndOtherSpaces) {
  const auto ours = makeSpaceInformation(graphOf(testTask(1, 0)));
  EXPECT_THAT([&] { GraphPlanner planner(ours, nullptr, "none"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("planner none is null")));
  const auto numbers = std::make_shared<ompl::base::DiscreteStateSpace>(0, 3);
  const auto theirs = std::make_shared<ompl::control::SpaceInformation>(
      numbers, std::make_shared<ompl::control::DiscreteControlSpace>(numbers, 0, 1));
  EXPECT_THAT([&] { GraphPlanner planner(theirs, std::make_shared<Waiting>(), "waiting"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("needs a SymbolStateSpace, found")));
}

/// Reads a log as OMPL's `ompl_benchmark_statistics.py` and Planner Arena do.
class BenchmarkLog {
 public:
  explicit BenchmarkLog(const std::string& text) : lines_(text) {
    EXPECT_THAT(line(), ::testing::StartsWith("OMPL version "));
    EXPECT_EQ(line(), "Experiment level 4");
    std::string next = line();
    while (lines_ && next.find(" enum type") == std::string::npos) next = line();
    for (int enums = std::stoi(next); enums > 0; --enums) line();
    for (int count = std::stoi(line()); count > 0; --count) readPlanner();
  }

  std::vector<std::string> planners;
  std::map<std::string, std::vector<double>> solved;

 private:
  std::string line() {
    std::string text;
    std::getline(lines_, text);
    return text;
  }

  void readPlanner() {
    planners.push_back(line());
    for (int common = std::stoi(line()); common > 0; --common) line();
    std::vector<std::string> properties;
    for (int count = std::stoi(line()); count > 0; --count) properties.push_back(line());
    for (int runs = std::stoi(line()); runs > 0; --runs) {
      std::istringstream values(line());
      for (const std::string& property : properties) {
        std::string value;
        std::getline(values, value, ';');
        if (property == "solved BOOLEAN") solved[planners.back()].push_back(std::stod(value));
      }
    }
    EXPECT_EQ(line(), ".");
  }

  std::istringstream lines_;
};

TEST_F(GraphPlannerTest, BenchmarkLogsReadAsOmplsOwn) {
  const auto setup = setupOf(graphOf(testTask(4, 0)));
  ompl::tools::Benchmark benchmark(*setup, "level 4");
  for (const char* name : {"belief", "bfs"}) {
    benchmark.addPlanner(std::make_shared<GraphPlanner>(
        setup->getSpaceInformation(), PlannerRegistry::standard().make(name), name));
  }
  benchmark.addPlanner(std::make_shared<ompl::control::RRT>(setup->getSpaceInformation()));
  ompl::tools::Benchmark::Request request;
  request.maxTime = kPatience_s;
  request.runCount = 3;
  request.displayProgress = false;
  request.saveConsoleOutput = false;
  benchmark.benchmark(request);
  std::ostringstream text;
  ASSERT_TRUE(benchmark.saveResultsToStream(text));
  const BenchmarkLog log(text.str());
  EXPECT_THAT(log.planners, ::testing::ElementsAre("control_belief", "control_bfs", "control_RRT"));
  for (const auto& [planner, solved] : log.solved) {
    EXPECT_THAT(solved, ::testing::ElementsAre(1, 1, 1)) << planner;
  }
  EXPECT_EQ(log.solved.size(), 3u);
}

}  // namespace
}  // namespace conceptplan
