#include "conceptplan/domain/scenario/scenario.hpp"

#include <gmock/gmock.h>

#include "domain/files/temporary_folder.hpp"
#include "domain/scenario/sample_scenario.hpp"

namespace conceptplan {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

GivenSymbols symbols(int x) {
  GivenSymbols given;
  given.fill(SymbolId{0});
  given[index(Concept::kPositionX)] = SymbolId{x};
  return given;
}

Scenario symbolScenario() {
  Scenario scenario;
  scenario.name = "symbols";
  scenario.input = SymbolInput{{symbols(0), symbols(1)}, symbols(2)};
  scenario.target = 2;
  return scenario;
}

TEST(ProblemOf, CertainSymbolsAndGivenProbabilities) {
  Scenario scenario = symbolScenario();
  std::get<SymbolInput>(scenario.input).goal[index(Concept::kRotation)] =
      std::vector<double>{0.5, 0.25, 0.25, 0};
  const SymbolicProblem problem = problemOf(scenario, kConceptCardinality);
  EXPECT_EQ(problem.initial.target, 1u);
  ASSERT_EQ(problem.initial.objects.size(), 2u);
  EXPECT_THAT(problem.initial.objects[1][index(Concept::kPositionX)], ElementsAre(0, 1, 0));
  EXPECT_THAT(problem.goal[index(Concept::kPositionX)], ElementsAre(0, 0, 1));
  EXPECT_THAT(problem.goal[index(Concept::kRotation)], ElementsAre(0.5, 0.25, 0.25, 0));
}

TEST(ProblemOf, NamesEverySymbolThatTheModelLacks) {
  Scenario scenario = symbolScenario();
  auto& input = std::get<SymbolInput>(scenario.input);
  input.goal = symbols(3);
  input.objects[0][index(Concept::kSize)] = std::vector<double>{1};
  scenario.target = 9;
  const std::string faults = faultsOf([&] { problemOf(scenario, kConceptCardinality); });
  EXPECT_THAT(faults, HasSubstr("goal.symbols.position_x: expected a symbol of the model, in "
                                "[0, 3), found 3"));
  EXPECT_THAT(faults, HasSubstr("initial.symbols.objects[0].size: expected one probability for "
                                "each of the model's 4 symbols, found 1"));
  EXPECT_THAT(faults, HasSubstr("target: expected an object in [1, 2], found 9"));
}

TEST(ProblemOf, PicturesAreABrokenPrecondition) {
  EXPECT_THROW(problemOf(pictureScenario(1), kConceptCardinality), std::invalid_argument);
}

TEST(Scenario, FaultKnowsTheLineOfItsKey) {
  Scenario scenario = symbolScenario();
  scenario.file = "s.yaml";
  scenario.positions["planner.name"] = {6, 17};
  EXPECT_EQ(scenario.fault("planner.name", "unknown").text(), "s.yaml:6:17: planner.name: unknown");
  EXPECT_EQ(scenario.fault("model", "absent").text(), "s.yaml: model: absent");
}

Scenario twoTargetScenario() {
  Scenario scenario = symbolScenario();
  scenario.input = SymbolInput{{symbols(0), symbols(1)}, {}, {symbols(2), symbols(0)}};
  scenario.target.reset();
  scenario.targets = {2, 1};
  return scenario;
}

TEST(JointProblemOf, EachTargetHasItsGoal) {
  const JointProblem problem = jointProblemOf(twoTargetScenario(), kConceptCardinality);
  ASSERT_EQ(problem.objects.size(), 2u);
  ASSERT_EQ(problem.targets.size(), 2u);
  EXPECT_EQ(problem.targets[0].object, 1u);
  EXPECT_EQ(problem.targets[0].name, "object 2");
  EXPECT_THAT(problem.targets[0].goal[index(Concept::kPositionX)], ElementsAre(0, 0, 1));
  EXPECT_THAT(problem.targets[1].goal[index(Concept::kPositionX)], ElementsAre(1, 0, 0));
}

TEST(JointProblemOf, NamesWhatIsWrong) {
  Scenario scenario = twoTargetScenario();
  scenario.targets[1] = 3;
  std::get<SymbolInput>(scenario.input).goals[1] = symbols(3);
  const std::string faults = faultsOf([&] { jointProblemOf(scenario, kConceptCardinality); });
  EXPECT_THAT(faults, HasSubstr("goal.symbols[1].position_x: expected a symbol of the model"));
  EXPECT_THAT(faults, HasSubstr("targets: expected an object in [1, 2], found 3"));
  EXPECT_THROW(jointProblemOf(symbolScenario(), kConceptCardinality), std::invalid_argument);
  EXPECT_THAT(faultsOf([&] { problemOf(twoTargetScenario(), kConceptCardinality); }),
              HasSubstr("targets: several targets, where one is expected"));
}

}  // namespace
}  // namespace conceptplan
