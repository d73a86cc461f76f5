#include "conceptplan/planners/planner_registry.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;

TEST(PlannerRegistry, HoldsTheStandardPlanners) {
  const PlannerRegistry registry = PlannerRegistry::standard();
  for (const char* planner : {"belief", "bfs", "dijkstra", "astar", "greedy", "kbest", "idastar",
                              "beam", "value-iteration", "lrtdp", "mcts"}) {
    EXPECT_NE(registry.find(planner), nullptr) << planner;
  }
  EXPECT_EQ(registry.find("no such planner"), nullptr);
}

TEST(PlannerRegistry, MakesEveryPlannerWithItsStandardOptions) {
  const PlannerRegistry registry = PlannerRegistry::standard();
  for (const PlannerEntry& entry : registry.entries()) {
    EXPECT_NE(registry.make(entry.name), nullptr) << entry.name;
    EXPECT_FALSE(entry.summary.empty());
    EXPECT_FALSE(entry.source.empty());
    EXPECT_FALSE(entry.guarantees.empty());
  }
}

TEST(PlannerRegistry, NamesTheNearestPlannerForAnUnknownOne) {
  try {
    PlannerRegistry::standard().make("beleif", {}, "scenario.yaml");
    FAIL() << "no error";
  } catch (const InputError& error) {
    ASSERT_EQ(error.faults().size(), 1u);
    EXPECT_EQ(error.faults()[0].text(),
              "scenario.yaml: planner.name: unknown planner \"beleif\"; did you mean \"belief\"?");
  }
}

TEST(PlannerRegistry, ChecksOptions) {
  EXPECT_THROW(PlannerRegistry::standard().make("bfs", {{"legality_threshold", "2"}}), InputError);
  EXPECT_THROW(PlannerRegistry::standard().make("beam", {{"width", "2.5"}}), InputError);
  EXPECT_NE(PlannerRegistry::standard().make("belief", {{"symbols", "hard"}}), nullptr);
}

TEST(PlannerRegistry, TakesPlannersOfAProgram) {
  PlannerRegistry registry = PlannerRegistry::standard();
  PlannerEntry entry = *registry.find("bfs");
  entry.name = "mine";
  registry.add(entry);
  EXPECT_NE(registry.make("mine"), nullptr);
  EXPECT_THAT([&] { registry.add(entry); }, ::testing::ThrowsMessage<std::invalid_argument>(
                                                "there is a planner \"mine\" already"));
}

TEST(PlannerRegistry, JsonHasTheStableNames) {
  const std::string json = toJson(PlannerRegistry::standard());
  for (const char* key :
       {"\"name\": \"belief\"", "\"summary\"", "\"source\"", "\"guarantees\"", "\"options\"",
        "\"default\": \"0.01\"", "\"range\": \"[0, 1]\"", "\"type\": \"number\""}) {
    EXPECT_THAT(json, HasSubstr(key));
  }
}

TEST(PlannerRegistry, DocsPlannersIsUpToDate) {
  const std::string expected = toMarkdown(PlannerRegistry::standard());
  std::ifstream file(CONCEPTPLAN_DOCS_FOLDER "/planners.md");
  std::stringstream text;
  text << file.rdbuf();
  const std::string fresh = ::testing::TempDir() + "planners.md";
  if (!text.str().starts_with(expected)) std::ofstream(fresh) << expected;
  // Planners of other components follow; their tests compare them.
  EXPECT_THAT(text.str(), ::testing::StartsWith(expected))
      << "put " << fresh << " at the beginning of docs/planners.md";
}

TEST(PlannerRegistry, MakesThePlannersOfSeveralTargets) {
  const PlannerRegistry registry = PlannerRegistry::standard();
  for (const char* planner : {"astar", "dijkstra", "greedy", "bfs"}) {
    EXPECT_NO_THROW(registry.makeJoint(planner, {{"legality_threshold", "0.02"}})) << planner;
  }
  EXPECT_THAT([&] { registry.makeJoint("belief", {}, "s.yaml"); },
              ::testing::ThrowsMessage<InputError>(
                  HasSubstr("s.yaml: planner.name: \"belief\" plans for one target; for several "
                            "there are bfs, dijkstra, astar, greedy")));
  EXPECT_THROW(registry.makeJoint("no such planner"), InputError);
  EXPECT_THROW(registry.makeJoint("astar", {{"step_discount", "2"}}), InputError);
}

}  // namespace
}  // namespace conceptplan
