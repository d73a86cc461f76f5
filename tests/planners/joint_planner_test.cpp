#include "conceptplan/planners/joint_planner.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <set>
#include <stdexcept>

#include "conceptplan/domain/simulation/judgement.hpp"
#include "conceptplan/domain/simulation/second_target.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"
#include "conceptplan/planners/best_first_planner.hpp"
#include "planners/joint_world.hpp"
#include "planners/learned_world.hpp"

namespace conceptplan {
namespace {

using testing::drawnJointGrid;
using testing::dyerWorld;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::jointGrid;
using testing::JointWorld;
using testing::learnedModel;
using testing::learnedRelabelling;
using testing::randomJointWorld;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;

constexpr double kThreshold = 0.01;
constexpr double kDiscount = 0.01;

PlanResult solved(const JointWorld& world, const PlanQuery& query = {},
                  const JointPlannerOptions& options = {}) {
  return JointPlanner(options).solve(world.model, world.problem, GridValidity(), query);
}

PlanQuery single(std::size_t horizon = 24) {
  PlanQuery query;
  query.top = 1;
  query.limits.horizon = horizon;
  return query;
}

/// The symbols of all objects after each step; fails where a step is not one of the model's.
void expectReplays(const JointWorld& world, const Plan& plan) {
  std::vector<Symbols> scene;
  for (const SymbolBelief& belief : world.problem.objects) scene.push_back(mostProbable(belief));
  ASSERT_THAT(plan.moved, SizeIs(plan.actions.size()));
  ASSERT_THAT(plan.predicted, SizeIs(plan.actions.size()));
  for (std::size_t i = 0; i < plan.actions.size(); ++i) {
    std::vector<Symbols> others = scene;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(plan.moved[i]));
    Symbols& moved = scene[plan.moved[i]];
    const Surroundings surroundings{world.model.grounding, moved, others};
    EXPECT_GT(world.model.legality.probability(plan.actions[i], surroundings), kThreshold);
    Symbols next{};
    for (const Concept which : kConcepts) {
      const std::vector<double> row =
          world.model.transitions.distribution(plan.actions[i], which, surroundings);
      next[index(which)] =
          static_cast<SymbolId>(std::max_element(row.begin(), row.end()) - row.begin());
    }
    EXPECT_EQ(next, plan.predicted[i]) << "step " << i;
    EXPECT_TRUE(
        GridValidity().check(world.problem.workbench, world.model.grounding, next, others).valid());
    moved = next;
  }
  for (const TargetGoal& target : world.problem.targets) {
    EXPECT_EQ(scene[target.object], mostProbable(target.goal));
  }
}

/// That the planner finds the least cost, and a plan that replays, or proves that there is none.
/// Hart, Nilsson and Raphael 1968: A* with an admissible heuristic does; here it is the sum of the
/// targets' own least costs (Silver 2005).
void expectOptimal(const JointWorld& world, std::size_t horizon,
                   const JointPlannerOptions& options = {}) {
  const auto least = testing::leastJointCost(world, horizon * world.problem.targets.size(),
                                             kThreshold, kDiscount, options.count_actions);
  const PlanResult result = solved(world, single(horizon), options);
  if (!least) {
    EXPECT_EQ(result.status, PlanStatus::kInfeasible) << result.reason;
    EXPECT_FALSE(result.reason.empty());
    return;
  }
  ASSERT_EQ(result.status, PlanStatus::kSolved) << result.reason;
  const Plan& plan = result.plans.front();
  EXPECT_NEAR(plan.cost, least->cost, 1e-6);
  EXPECT_LE(plan.actions.size(), least->steps);
  expectReplays(world, plan);
}

TEST(JointPlanner, IsOptimalOnDrawnGridsWithTwoTargets) {
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    expectOptimal(drawnJointGrid(3, 3, 2, 2, seed % 4, seed), 8);
  }
}

TEST(JointPlanner, IsOptimalOnCrowdedGridsWithThreeTargets) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    expectOptimal(drawnJointGrid(3, 2, 1, 3, seed % 2, seed), 8);
  }
}

TEST(JointPlanner, IsOptimalWhereOutcomesAreUncertain) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expectOptimal(randomJointWorld(seed), 8);
  }
}

TEST(JointPlanner, IsOptimalWhereATargetTakesTheSymbolsOfAnother) {
  std::size_t feasible = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE(seed);
    expectOptimal(dyerWorld(seed), 10);
    feasible += testing::leastJointCost(dyerWorld(seed), 20, kThreshold, kDiscount) ? 1 : 0;
  }
  EXPECT_GT(feasible, 20u);
}

TEST(JointPlanner, IsOptimalWithinAShortHorizon) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    expectOptimal(randomJointWorld(seed), 1 + seed % 3);
  }
}

TEST(JointPlanner, FewestActionsAndNoGuidanceAreOptimalToo) {
  JointPlannerOptions fewest;
  fewest.count_actions = true;
  JointPlannerOptions unguided;
  unguided.guided = false;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    expectOptimal(randomJointWorld(seed), 8, fewest);
    expectOptimal(randomJointWorld(seed), 8, unguided);
  }
}

TEST(JointPlanner, GreedyFindsAPlanWhereThereIsOne) {
  JointPlannerOptions greedy;
  greedy.greedy = true;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const JointWorld world = drawnJointGrid(3, 3, 1, 2, 2, seed);
    const PlanResult best = solved(world, single());
    const PlanResult result = solved(world, single(), greedy);
    EXPECT_EQ(result.status, best.status);
    if (!result.plans.empty()) {
      expectReplays(world, result.plans.front());
      EXPECT_GE(result.plans.front().cost, best.plans.front().cost - 1e-9);
    }
  }
}

TEST(JointPlanner, TargetsCannotSwapInACorridor) {
  const JointWorld world = jointGrid(5, 1, 1, {{{1, 0}, {3, 0}}, {{3, 0}, {1, 0}}});
  const PlanResult result = solved(world);
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_EQ(result.reason,
            "no legal and valid steps lead all targets to their goals within 48 actions");
}

TEST(JointPlanner, OneTargetStepsAsideSoThatTheySwap) {
  // A corridor with one bay above its middle.
  const JointWorld world =
      jointGrid(3, 2, 1, {{{0, 0}, {2, 0}}, {{2, 0}, {0, 0}}}, {{0, 1}, {2, 1}});
  const PlanResult result = solved(world, single());
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.plans.front().actions, SizeIs(6));  // two beyond the sum of the two alone
  expectReplays(world, result.plans.front());
}

TEST(JointPlanner, InACorridorTheFirstGoesFirst) {
  const JointWorld world = jointGrid(4, 1, 1, {{{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}});
  const PlanResult result = solved(world, single());
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  const Plan& plan = result.plans.front();
  EXPECT_THAT(plan.actions, SizeIs(4));
  EXPECT_EQ(plan.moved.front(), 1u);
}

TEST(JointPlanner, TurnsFromOneTargetToTheOtherNoMoreThanNeeded) {
  const JointWorld world = jointGrid(4, 2, 1, {{{0, 0}, {3, 0}}, {{0, 1}, {3, 1}}});
  const PlanResult result = solved(world, single());
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.plans.front().moved, ElementsAre(0, 0, 0, 1, 1, 1));
}

TEST(JointPlanner, ATargetThatIsThereAlreadyGivesWay) {
  const JointWorld world =
      jointGrid(3, 2, 1, {{{0, 0}, {2, 0}}, {{1, 0}, {1, 0}}}, {{0, 1}, {2, 1}});
  const PlanResult result = solved(world, single());
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.plans.front().moved, ElementsAre(1, 0, 0, 1));
  expectReplays(world, result.plans.front());
}

// The k shortest paths problem (Eppstein 1998), against full enumeration.
TEST(JointPlanner, PlansAreTheBestOnesUpToTheOrderOfTheTargets) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const JointWorld world = randomJointWorld(seed);
    PlanQuery query = single(2);
    query.top = 7;
    const PlanResult result = solved(world, query);
    const std::vector<double> expected = testing::allJointCosts(world, 4, kThreshold, kDiscount);
    ASSERT_EQ(result.plans.size(), std::min<std::size_t>(7, expected.size()));
    std::set<std::vector<ActionSequence>> seen;
    for (std::size_t i = 0; i < result.plans.size(); ++i) {
      EXPECT_NEAR(result.plans[i].cost, expected[i], 1e-6);
      expectReplays(world, result.plans[i]);
      std::vector<ActionSequence> sequences(2);
      for (std::size_t step = 0; step < result.plans[i].actions.size(); ++step) {
        sequences[result.plans[i].moved[step]].push_back(result.plans[i].actions[step]);
      }
      EXPECT_TRUE(seen.insert(sequences).second);
    }
  }
}

Task testTask(int level, int number) {
  TaskOptions options;
  options.level = level;
  options.split = Split::kTest;
  options.seed = 7;
  return TaskGenerator(options).task(number);
}

TEST(JointPlanner, PlansForOneTargetAsAStarDoes) {
  for (int level = 2; level <= 4; ++level) {
    for (int i = 0; i < 10; ++i) {
      SCOPED_TRACE(level * 100 + i);
      const Task task = testTask(level, i);
      const PlanResult expected = BestFirstPlanner().solve(
          compile(learnedModel(), learnedRelabelling().problem(task), GridValidity()), PlanQuery{});
      const PlanResult result = solved(testing::learnedJointWorld(task));
      ASSERT_EQ(result.status, expected.status);
      ASSERT_EQ(result.plans.size(), expected.plans.size());
      for (std::size_t p = 0; p < result.plans.size(); ++p) {
        EXPECT_NEAR(result.plans[p].cost, expected.plans[p].cost, 1e-6);
        EXPECT_EQ(result.plans[p].actions.size(), expected.plans[p].actions.size());
        EXPECT_NEAR(result.plans[p].probability, expected.plans[p].probability, 1e-6);
      }
      EXPECT_EQ(result.plans.front().predicted.size(), result.plans.front().actions.size());
    }
  }
}

TEST(JointPlanner, PlansFromLearnedTablesAreAsShortAsTheSimulatorAllows) {
  for (int i = 0; i < 30; ++i) {
    SCOPED_TRACE(i);
    RandomStream random{static_cast<std::uint64_t>(i)};
    const std::optional<Task> task = withSecondTarget(testTask(4, i), random);
    if (!task) continue;
    const PlanResult result = solved(testing::learnedJointWorld(*task));
    ASSERT_EQ(result.status, PlanStatus::kSolved) << result.reason;
    for (const Plan& plan : result.plans) {
      EXPECT_TRUE(judge(*task, plan.actions, plan.moved).succeeded());
    }
    const Plan& best = result.plans.front();
    EXPECT_EQ(judge(*task, best.actions, best.moved).efficiency, 1.0);
  }
}

TEST(JointPlanner, ProbabilityCountsReadingsAndOutcomes) {
  JointWorld world = jointGrid(3, 1, 1, {{{0, 0}, {1, 0}}, {{2, 0}, {2, 0}}});
  world.problem.objects[0][index(Concept::kPositionX)] = {0.9, 0.1, 0};
  world.problem.targets[1].goal[index(Concept::kPositionX)] = {0, 0.2, 0.8};
  const PlanResult result = solved(world, single());
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_NEAR(result.plans.front().probability, 0.9 * 0.8, 1e-9);
}

TEST(JointPlanner, NothingToDoIsAPlan) {
  const JointWorld world = jointGrid(3, 1, 1, {{{0, 0}, {0, 0}}, {{2, 0}, {2, 0}}});
  const PlanResult result = solved(world, single());
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.plans.front().actions, IsEmpty());
  EXPECT_EQ(result.plans.front().cost, 0);
}

TEST(JointPlanner, TellsGivingUpFromInfeasible) {
  const JointWorld world = drawnJointGrid(5, 5, 4, 3, 3, 1);
  PlanQuery query = single();
  query.limits.max_expansions = 3;
  PlanResult result = solved(world, query);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.statistics.expanded, 3u);
  EXPECT_THAT(result.reason, HasSubstr("3 expansions"));

  query = single();
  query.limits.timeout_s = 1e-9;
  EXPECT_EQ(solved(world, query).status, PlanStatus::kTimeout);

  const std::atomic<bool> cancel{true};
  query = single();
  query.limits.cancel = &cancel;
  result = solved(world, query);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.reason, "cancelled");

  EXPECT_EQ(solved(world, single(1)).status, PlanStatus::kInfeasible);
}

TEST(JointPlanner, ALimitBetweenTheFirstPlanAndTheOthersKeepsTheFirst) {
  const JointWorld world = jointGrid(4, 2, 1, {{{0, 0}, {3, 0}}, {{0, 1}, {3, 1}}});
  const std::size_t needed = solved(world, single()).statistics.expanded;
  PlanQuery query;
  query.limits.max_expansions = needed + 1;
  const PlanResult result = solved(world, query);
  EXPECT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.plans, SizeIs(1));
  EXPECT_THAT(result.reason, HasSubstr("the best plans found so far"));
}

TEST(JointPlanner, RefusesProblemsThatDoNotFit) {
  const JointWorld good = jointGrid(3, 1, 1, {{{0, 0}, {1, 0}}, {{2, 0}, {2, 0}}});
  const auto refused = [&](auto change) {
    JointWorld world = good;
    change(world.problem);
    return [world] { solved(world); };
  };
  EXPECT_THAT(refused([](JointProblem& problem) { problem.targets.clear(); }),
              ThrowsMessage<std::invalid_argument>("the problem has no targets"));
  EXPECT_THAT(refused([](JointProblem& problem) { problem.targets[1].object = 2; }),
              ThrowsMessage<std::invalid_argument>("a target is object 2 of 2"));
  EXPECT_THAT(refused([](JointProblem& problem) { problem.targets[1].object = 0; }),
              ThrowsMessage<std::invalid_argument>("object 0 is a target twice"));
  EXPECT_THAT(refused([](JointProblem& problem) {
                problem.targets[1].goal[index(Concept::kPositionX)] = {1};
              }),
              ThrowsMessage<std::invalid_argument>(
                  "goal of object 1, POSITION_X: expected 3 symbols, found 1"));
  PlanQuery none;
  none.top = 0;
  EXPECT_THROW(solved(good, none), std::invalid_argument);
  JointPlannerOptions options;
  options.step_discount = 0.7;
  EXPECT_THAT([&] { JointPlanner{options}; },
              ThrowsMessage<std::invalid_argument>(HasSubstr("step_discount is 0.7")));
}

}  // namespace
}  // namespace conceptplan
