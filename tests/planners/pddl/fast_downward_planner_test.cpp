#include "conceptplan/planners/pddl/fast_downward_planner.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/planners/best_first_planner.hpp"
#include "conceptplan/planners/pddl/plan_replay.hpp"
#include "domain/files/temporary_folder.hpp"
#include "planners/random_world.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using testing::tinySymbols;

/// From one end to the other, half a turn away: three steps.
SymbolGraph tinyGraph() {
  return compile(testing::tinyModel(),
                 testing::tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0)),
                 GridValidity());
}

/// Whether the process ends within some seconds; whoever adopts an orphan may not bury it.
bool ends(pid_t id) {
  for (int i = 0; i < 500; ++i) {
    std::ifstream stat("/proc/" + std::to_string(id) + "/stat");
    std::string number, name, state;
    if (!(stat >> number >> name >> state) || state == "Z") return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

class FastDownwardPlannerTest : public ::testing::Test {
 protected:
  void SetUp() override { ::setenv("TMPDIR", temporary_.c_str(), 1); }
  void TearDown() override {
    EXPECT_TRUE(std::filesystem::is_empty(temporary_)) << "something is left";
    ::unsetenv("TMPDIR");
  }

  /// A shell script in place of the program.
  std::filesystem::path script(const std::string& text, const std::string& name = "program") const {
    const std::filesystem::path path = folder_.write(name, "#!/bin/sh\n" + text + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  }

  PlanResult solve(const std::filesystem::path& program, const PlanQuery& query = {}) const {
    return FastDownwardPlanner(program).solve(tinyGraph(), query);
  }

  const TemporaryFolder folder_;
  const std::filesystem::path temporary_ = [this] {
    std::filesystem::create_directory(folder_ / "tmp");
    return folder_ / "tmp";
  }();
};

TEST_F(FastDownwardPlannerTest, SolvesTheExportedTextAsWellAsOurs) {
  const FastDownwardPlanner planner(CONCEPTPLAN_FAST_DOWNWARD_STAND_IN);
  PlanQuery query;
  query.top = 1;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    const SymbolGraph graph = testing::randomWorld(seed);
    const PlanResult ours = BestFirstPlanner().solve(graph, query);
    const PlanResult theirs = planner.solve(graph, query);
    EXPECT_EQ(theirs.status, ours.status) << seed << ": " << theirs.reason;
    ASSERT_EQ(theirs.plans.size(), ours.plans.size());
    if (ours.plans.empty()) continue;
    EXPECT_NEAR(theirs.plans[0].cost, ours.plans[0].cost, 1e-5);
    EXPECT_EQ(theirs.plans[0].predicted.size(), theirs.plans[0].actions.size());
    EXPECT_GT(theirs.plans[0].probability, 0);
  }
}

TEST_F(FastDownwardPlannerTest, GivesTheProgramItsArgumentsWithoutAShell) {
  const std::string seen = (folder_ / "seen").string();
  PlanQuery query;
  query.limits.timeout_s = 7.5;
  const PlanResult result = solve(script("for word; do echo \"$word\"; done > " + seen +
                                         "; ls >> " + seen + "; echo >&2 oh dear; exit 33"),
                                  query);
  EXPECT_EQ(readFile(seen),
            "--overall-time-limit\n8s\n--plan-file\nsas_plan\ndomain.pddl\nproblem.pddl\n"
            "--search\nastar(lmcut())\ndomain.pddl\nlog\nproblem.pddl\n");
  EXPECT_EQ(result.status, PlanStatus::kFailed);
  EXPECT_EQ(result.reason, "fast-downward ended with exit code 33: oh dear");
}

TEST_F(FastDownwardPlannerTest, ReadsSeveralPlansBestFirst) {
  const std::string shortest = "(move_right)\\n(move_right)\\n(rotate_left)\\n";
  const PlanResult result =
      solve(script("printf '(rotate_left)\\n(rotate_left)\\n" + shortest + "' > sas_plan.1\n" +
                   "printf '" + shortest + "' > sas_plan.2; printf '" + shortest +
                   "' > sas_plan.3; echo 'Expanded 12 state(s).'"));
  ASSERT_EQ(result.status, PlanStatus::kSolved) << result.reason;
  ASSERT_EQ(result.plans.size(), 2u);
  EXPECT_EQ(result.plans[0].actions.size(), 3u);
  EXPECT_EQ(result.plans[1].actions.size(), 5u);
  EXPECT_LT(result.plans[0].cost, result.plans[1].cost);
  EXPECT_EQ(result.statistics.expanded, 12u);
}

TEST_F(FastDownwardPlannerTest, AWrongPlanIsAFailure) {
  const PlanResult illegal = solve(script("echo '(move_left)' > sas_plan"));
  EXPECT_EQ(illegal.status, PlanStatus::kFailed);
  EXPECT_TRUE(illegal.plans.empty());
  EXPECT_THAT(illegal.reason,
              HasSubstr("fast-downward wrote a wrong plan: step 1: the action is not legal"));
  const PlanResult torn = solve(script("printf '(move_ri' > sas_plan"));
  EXPECT_EQ(torn.status, PlanStatus::kFailed);
  EXPECT_THAT(torn.reason, HasSubstr("expected (ACTION ARGUMENT...)"));
  const PlanResult nothing = solve(script("exit 0"));
  EXPECT_EQ(nothing.status, PlanStatus::kFailed);
  EXPECT_EQ(nothing.reason, "fast-downward wrote no plan: it wrote nothing");
}

TEST_F(FastDownwardPlannerTest, ExitCodesTellProofsFromGivingUp) {
  const std::vector<std::pair<int, PlanStatus>> codes{
      {10, PlanStatus::kInfeasible}, {11, PlanStatus::kInfeasible}, {12, PlanStatus::kLimit},
      {20, PlanStatus::kLimit},      {21, PlanStatus::kTimeout},    {22, PlanStatus::kLimit},
      {23, PlanStatus::kTimeout},    {24, PlanStatus::kLimit},      {32, PlanStatus::kFailed}};
  for (const auto& [code, status] : codes) {
    const PlanResult result = solve(script("exit " + std::to_string(code)));
    EXPECT_EQ(result.status, status) << code;
    EXPECT_FALSE(result.reason.empty()) << code;
  }
  EXPECT_EQ(solve(script("kill -9 $$")).status, PlanStatus::kFailed);
}

TEST_F(FastDownwardPlannerTest, IsKilledAtTheTimeLimitWithAllThatItStarted) {
  const std::string ids = (folder_ / "ids").string();
  PlanQuery query;
  query.limits.timeout_s = 0.3;
  const auto begin = std::chrono::steady_clock::now();
  const PlanResult result =
      solve(script("sleep 100 & echo $! > " + ids + "; echo $$ >> " + ids + "; wait"), query);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
  EXPECT_EQ(result.status, PlanStatus::kTimeout);
  EXPECT_THAT(result.reason, HasSubstr("time limit"));
  std::istringstream text(readFile(ids));
  int started = 0;
  for (pid_t id = 0; text >> id; ++started) EXPECT_TRUE(ends(id)) << id << " runs on";
  EXPECT_EQ(started, 2);
}

TEST_F(FastDownwardPlannerTest, PlansWrittenBeforeTheTimeLimitCount) {
  PlanQuery query;
  query.limits.timeout_s = 0.5;
  const PlanResult result =
      solve(script("printf '(move_right)\\n(move_right)\\n(rotate_left)\\n' > sas_plan.1; printf "
                   "'(move_rig' > sas_plan.2; sleep 100"),
            query);
  EXPECT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_EQ(result.plans.size(), 1u);
  EXPECT_THAT(result.reason, HasSubstr("the best plans found so far"));
}

TEST_F(FastDownwardPlannerTest, ACancelKillsIt) {
  std::atomic<bool> cancel{false};
  PlanQuery query;
  query.limits.timeout_s = 100;
  query.limits.cancel = &cancel;
  std::thread later([&cancel] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    cancel = true;
  });
  const PlanResult result = solve(script("sleep 100"), query);
  later.join();
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_EQ(result.reason, "cancelled");
}

TEST_F(FastDownwardPlannerTest, APlanBeyondTheHorizonIsNoProof) {
  PlanQuery query;
  query.limits.horizon = 2;
  const PlanResult result = solve(CONCEPTPLAN_FAST_DOWNWARD_STAND_IN, query);
  EXPECT_EQ(result.status, PlanStatus::kLimit);
  EXPECT_THAT(result.reason, HasSubstr("has 3 actions, which is beyond the horizon of 2"));
}

TEST_F(FastDownwardPlannerTest, AProgramThatCannotBeStartedIsNamed) {
  const PlanResult result = solve(folder_ / "nowhere");
  EXPECT_EQ(result.status, PlanStatus::kFailed);
  EXPECT_THAT(result.reason, HasSubstr("nowhere cannot be started: No such file"));
}

TEST_F(FastDownwardPlannerTest, IsAPlannerByNameWhereTheProgramIsOnThePath) {
  const std::string path = std::getenv("PATH");
  std::filesystem::create_directory(folder_ / "empty");
  std::filesystem::create_directory(folder_ / "bin");
  ::setenv("PATH", ("bin::" + (folder_ / "empty").string()).c_str(), 1);
  EXPECT_EQ(findFastDownward(), std::nullopt);
  PlannerRegistry without;
  addFastDownwardPlanner(without);
  EXPECT_EQ(without.find("fast-downward"), nullptr);
  EXPECT_THAT([&] { without.make("fast-downward", {}, "scenario.yaml"); },
              ::testing::ThrowsMessage<InputError>(HasSubstr(
                  "scenario.yaml: planner.name: planner \"fast-downward\" needs the program "
                  "fast-downward or fast-downward.py on the PATH")));

  script("exit 11", "bin/fast-downward.py");
  ::setenv("PATH", ((folder_ / "empty").string() + ":" + (folder_ / "bin").string()).c_str(), 1);
  EXPECT_EQ(findFastDownward(), folder_ / "bin/fast-downward.py");
  script("exit 12", "bin/fast-downward");
  EXPECT_EQ(findFastDownward(), folder_ / "bin/fast-downward");
  PlannerRegistry with;
  addFastDownwardPlanner(with);
  EXPECT_EQ(with.make("fast-downward", {{"search", "lama"}})->solve(tinyGraph(), {}).status,
            PlanStatus::kLimit);
  EXPECT_THROW(with.make("fast-downward", {{"search", "lmcut)"}}), InputError);
  EXPECT_THROW(addFastDownwardPlanner(with), std::invalid_argument);
  ::setenv("PATH", path.c_str(), 1);
}

TEST(FastDownwardEntry, DocsPlannersHasItAsTheRegistryDoes) {
  PlannerRegistry registry;
  registry.add(fastDownwardEntry("/usr/bin/fast-downward"));
  const std::string all = toMarkdown(registry);
  const std::string expected = all.substr(all.find("\n## "));
  const std::string fresh = ::testing::TempDir() + "fast_downward_planner.md";
  const std::string text = readFile(CONCEPTPLAN_DOCS_FOLDER "/planners.md");
  if (text.find(expected) == std::string::npos) std::ofstream(fresh) << expected;
  EXPECT_THAT(text, HasSubstr(expected))
      << "put " << fresh << " into docs/planners.md before the planners of OMPL";
}

TEST(FastDownwardPlanner, RefusesOptionsOutOfRange) {
  EXPECT_THROW(FastDownwardPlanner("/bin/true", {.legality_threshold = 2}), std::invalid_argument);
  EXPECT_THROW(FastDownwardPlanner("/bin/true", {.step_discount = 0.6}), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
