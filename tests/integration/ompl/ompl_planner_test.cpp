#include "conceptplan/ompl/ompl_planner.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <future>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/simulation/simulator.hpp"
#include "integration/ompl/task_graph.hpp"
#include "planners/random_world.hpp"

namespace conceptplan {
namespace {

using testing::graphOf;
using ::testing::HasSubstr;
using testing::learnedRelabelling;
using testing::lockedInTask;
using testing::testTask;
using ::testing::ThrowsMessage;

PlannerRegistry omplRegistry() {
  PlannerRegistry registry;
  addOmplPlanners(registry);
  return registry;
}

/// No time limit strikes, however busy the machine is.
PlanQuery patientQuery() {
  PlanQuery query;
  query.limits.timeout_s = 600;
  return query;
}

/// What holds of each planner of OMPL under our contract; none of them promises shortest plans.
class OmplPlannerContract : public ::testing::TestWithParam<std::string> {
 protected:
  PlanResult solve(const Task& task, const PlanQuery& query = patientQuery()) const {
    return planner_->solve(*graphOf(task), query);
  }

  const std::unique_ptr<Planner> planner_ = omplRegistry().make(GetParam());
};

TEST_P(OmplPlannerContract, StartEqualsGoalGivesTheEmptyPlan) {
  Task task = testTask(2, 0);
  task.goal = task.initial.objects[task.initial.target];
  const PlanResult result = solve(task);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  ASSERT_EQ(result.plans.size(), 1u);
  EXPECT_TRUE(result.plans.front().actions.empty());
}

TEST_P(OmplPlannerContract, AGoalOutOfReachIsProvedInfeasible) {
  const PlanResult result = solve(lockedInTask());
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_TRUE(result.plans.empty());
  EXPECT_FALSE(result.reason.empty());
  EXPECT_FALSE(result.rejections.empty());
}

TEST_P(OmplPlannerContract, EveryPlanOfEveryLevelReplaysInTheSimulator) {
  for (int level = 1; level <= 4; ++level) {
    for (int i = 0; i < 15; ++i) {
      const Task task = testTask(level, i);
      const PlanResult result = solve(task);
      ASSERT_EQ(result.status, PlanStatus::kSolved) << task.id << ": " << result.reason;
      for (const Plan& plan : result.plans) {
        EXPECT_GE(plan.actions.size(), task.reference.size()) << task.id;
        EXPECT_NEAR(plan.probability, 1, 1e-9);
        ASSERT_EQ(plan.predicted.size(), plan.actions.size());
        World world = task.initial;
        for (std::size_t step = 0; step < plan.actions.size(); ++step) {
          ASSERT_FALSE(advance(world, plan.actions[step])) << task.id;
          EXPECT_EQ(plan.predicted[step],
                    learnedRelabelling().symbols(world.objects[world.target]));
        }
        EXPECT_EQ(world.objects[world.target], task.goal) << task.id;
      }
    }
  }
}

TEST_P(OmplPlannerContract, PlansAreDistinctWithoutLoopsAndShortestFirst) {
  const Task task = testTask(4, 3);
  const PlanResult result = solve(task);
  std::set<ActionSequence> distinct;
  for (const Plan& plan : result.plans) {
    distinct.insert(plan.actions);
    EXPECT_EQ(plan.cost, static_cast<double>(plan.actions.size()));
    const std::set<Symbols> states(plan.predicted.begin(), plan.predicted.end());
    EXPECT_EQ(states.size(), plan.predicted.size());
  }
  EXPECT_EQ(distinct.size(), result.plans.size());
  EXPECT_LE(result.plans.size(), patientQuery().top);
  EXPECT_TRUE(std::is_sorted(result.plans.begin(), result.plans.end(),
                             [](const Plan& a, const Plan& b) { return a.cost < b.cost; }));
}

TEST_P(OmplPlannerContract, TheSameSeedGivesTheSameResultInAnyThread) {
  const auto graph = graphOf(testTask(4, 5));
  PlanQuery query = patientQuery();
  query.seed = 11;
  const PlanResult alone = planner_->solve(*graph, query);
  std::vector<std::future<PlanResult>> results;
  for (int i = 0; i < 4; ++i) {
    results.push_back(
        std::async(std::launch::async, [&] { return planner_->solve(*graph, query); }));
  }
  for (auto& result : results) EXPECT_EQ(result.get(), alone);
}

TEST_P(OmplPlannerContract, TheLimitOfExpansionsIsHonoured) {
  PlanQuery query = patientQuery();
  query.limits.max_expansions = 1;
  const PlanResult result = solve(testTask(3, 1), query);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.statistics.expanded, 1u);
  EXPECT_THAT(result.reason, HasSubstr("limit of 1 expansions"));
}

TEST_P(OmplPlannerContract, ATimeLimitIsHonoured) {
  PlanQuery query;
  query.limits.timeout_s = 1e-9;
  const PlanResult result = solve(testTask(3, 1), query);
  EXPECT_EQ(result.status, PlanStatus::kTimeout);
  EXPECT_THAT(result.reason, HasSubstr("time limit"));
}

TEST_P(OmplPlannerContract, ACancelIsHonoured) {
  const std::atomic<bool> cancel{true};
  PlanQuery query = patientQuery();
  query.limits.cancel = &cancel;
  const PlanResult result = solve(testTask(3, 1), query);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.reason, "cancelled");
}

TEST_P(OmplPlannerContract, TheHorizonIsHonouredAndGivingUpIsNoProof) {
  const Task task = testTask(4, 2);
  PlanQuery query = patientQuery();
  query.limits.horizon = task.reference.size() - 1;
  EXPECT_EQ(solve(task, query).status, PlanStatus::kInfeasible);
  query.limits.horizon = task.reference.size();
  query.limits.max_expansions = 3000;
  const PlanResult result = solve(task, query);
  EXPECT_NE(result.status, PlanStatus::kInfeasible);
  for (const Plan& plan : result.plans) EXPECT_EQ(plan.actions.size(), task.reference.size());
}

/// By brute force: the state that a legal action most probably leads to, if it is valid.
std::optional<StateId> stepOf(const SymbolGraph& graph, StateId state, Action action) {
  if (graph.legality(state, action) <= 0.01) return std::nullopt;
  const StateId next = graph.transitions(state, action).front().state;
  if (!graph.valid(next)) return std::nullopt;
  return next;
}

/// By brute force: whether at most so many such steps lead from start to goal.
bool hasPlan(const SymbolGraph& graph, std::size_t horizon) {
  std::set<StateId> reached{graph.mostProbableStart()};
  for (std::size_t step = 0; step < horizon; ++step) {
    std::set<StateId> more = reached;
    for (const StateId state : reached) {
      for (const Action action : kActions) {
        if (const auto next = stepOf(graph, state, action)) more.insert(*next);
      }
    }
    reached = std::move(more);
  }
  return reached.contains(graph.mostProbableGoal());
}

TEST_P(OmplPlannerContract, PlansOfRandomWorldsAreLegalByBruteForceAndNoneIsMissedOrInvented) {
  std::size_t solved = 0, infeasible = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = testing::randomWorld(seed);
    PlanQuery query = patientQuery();
    query.seed = seed;
    query.top = 3;
    query.limits.horizon = 12;
    const PlanResult result = planner_->solve(graph, query);
    if (!hasPlan(graph, query.limits.horizon)) {
      EXPECT_EQ(result.status, PlanStatus::kInfeasible) << result.reason;
      EXPECT_TRUE(result.plans.empty());
      ++infeasible;
      continue;
    }
    ASSERT_EQ(result.status, PlanStatus::kSolved) << result.reason;
    for (const Plan& plan : result.plans) {
      EXPECT_LE(plan.actions.size(), query.limits.horizon);
      StateId state = graph.mostProbableStart();
      for (std::size_t i = 0; i < plan.actions.size(); ++i) {
        const std::optional<StateId> next = stepOf(graph, state, plan.actions[i]);
        ASSERT_TRUE(next.has_value()) << "step " << i;
        state = *next;
        EXPECT_EQ(plan.predicted[i], graph.symbols(state));
      }
      EXPECT_EQ(state, graph.mostProbableGoal());
    }
    ++solved;
  }
  EXPECT_GT(solved, 20u);
  EXPECT_GT(infeasible, 10u);
}

TEST_P(OmplPlannerContract, CountsWhatIsRuledOutInTheProofAndInTheRuns) {
  PlanQuery query = patientQuery();
  query.top = 1;
  query.count_rejections = true;
  for (const Task& task : {lockedInTask(), testTask(3, 1)}) {
    const PlanResult result = solve(task, query);
    ASSERT_TRUE(result.ruled_out) << task.id;
    EXPECT_GT(result.ruled_out->states, 0u);
    EXPECT_FALSE(result.ruled_out->counts.empty());
  }
}

TEST_P(OmplPlannerContract, SaysNothing) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  solve(testTask(1, 0));
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

std::vector<std::string> omplNames() {
  std::vector<std::string> names;
  const PlannerRegistry registry = omplRegistry();
  for (const PlannerEntry& entry : registry.entries()) names.push_back(entry.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(EveryAlgorithm, OmplPlannerContract, ::testing::ValuesIn(omplNames()),
                         [](const auto& planner) {
                           std::string name = planner.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(OmplPlanner, TheRegistryNamesThemBesideOurs) {
  PlannerRegistry registry = PlannerRegistry::standard();
  addOmplPlanners(registry);
  EXPECT_THAT(omplNames(), ::testing::ElementsAre("ompl-rrt", "ompl-est", "ompl-kpiece", "ompl-sst",
                                                  "ompl-pdst", "ompl-syclop-rrt"));
  for (const std::string& name : omplNames()) {
    ASSERT_NE(registry.find(name), nullptr);
    EXPECT_FALSE(registry.find(name)->summary.empty());
    EXPECT_THAT(registry.find(name)->source, HasSubstr("doi:"));
  }
  EXPECT_THROW(addOmplPlanners(registry), std::invalid_argument);
}

TEST(OmplPlanner, OptionsAreCheckedAndUsed) {
  const PlannerRegistry registry = omplRegistry();
  EXPECT_THROW(registry.make("ompl-rrt", {{"goal_bias", "2"}}), InputError);
  EXPECT_THROW(registry.make("ompl-rrt", {{"control_samples", "0.5"}}), InputError);
  EXPECT_THROW(registry.make("ompl-kpiece", {{"control_samples", "3"}}), InputError);
  const auto graph = graphOf(testTask(4, 4));
  PlanQuery query = patientQuery();
  query.top = 1;
  const auto expanded = [&](const std::string& steps) {
    return registry.make("ompl-sst", {{"improvement_steps", steps}})
        ->solve(*graph, query)
        .statistics.expanded;
  };
  EXPECT_EQ(expanded("200"), expanded("0") + 200);
}

TEST(OmplPlanner, RefusesOptionsOutOfRange) {
  EXPECT_THAT([] { OmplPlanner planner(OmplAlgorithm::kRrt, {.legality_threshold = -1}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("legality_threshold is -1")));
  EXPECT_THAT([] { OmplPlanner planner(OmplAlgorithm::kRrt, {.goal_bias = 1.5}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("goal_bias is 1.5")));
  EXPECT_THAT([] { OmplPlanner planner(OmplAlgorithm::kRrt, {.control_samples = 0}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("control_samples is 0")));
}

TEST(OmplPlanner, DocsPlannersNamesThemAsTheRegistryDoes) {
  std::ifstream file(CONCEPTPLAN_DOCS_FOLDER "/planners.md");
  std::stringstream text;
  text << file.rdbuf();
  const std::string all = toMarkdown(omplRegistry());
  const std::string expected = all.substr(all.find("## ompl-rrt"));
  const std::string fresh = ::testing::TempDir() + "ompl_planners.md";
  if (!text.str().ends_with(expected)) std::ofstream(fresh) << expected;
  EXPECT_THAT(text.str(), ::testing::EndsWith(expected))
      << "put " << fresh << " at the end of docs/planners.md";
}

}  // namespace
}  // namespace conceptplan
