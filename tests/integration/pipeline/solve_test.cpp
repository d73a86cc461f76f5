#include "conceptplan/pipeline/solve.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/rendering/renderer.hpp"
#include "conceptplan/domain/scenario/scenario_file.hpp"
#include "conceptplan/planners/belief_planner.hpp"

namespace conceptplan {
namespace {

const Model& shippedModel() {
  static const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  return model;
}

Scenario shipped(const std::string& name) {
  return readScenario(std::filesystem::path(CONCEPTPLAN_SCENARIOS) / name);
}

GivenSymbols given(const SymbolBelief& belief) {
  GivenSymbols symbols;
  std::ranges::copy(belief, symbols.begin());
  return symbols;
}

TEST(SolveScenario, SolvesAShippedScenarioFromItsPictures) {
  const Scenario scenario = shipped("level3-0001");
  const Solution solution = solveScenario(scenario, shippedModel(), BeliefPlanner());
  ASSERT_EQ(solution.result.status, PlanStatus::kSolved) << solution.result.reason;
  ASSERT_TRUE(solution.evaluation.has_value());
  EXPECT_TRUE(solution.evaluation->best.succeeded());
  EXPECT_EQ(solution.frames.size(), solution.result.plans.front().actions.size());
  const Report report = reportOf(scenario, shippedModel(), solution, "belief", 0);
  EXPECT_EQ(report.frames.size(), solution.frames.size());
  EXPECT_THAT(renderReport(report), testing::HasSubstr("level3-0001"));
}

TEST(SolveScenario, SaysWhyThereIsNoPlan) {
  const Solution solution =
      solveScenario(shipped("infeasible-0001"), shippedModel(), BeliefPlanner());
  EXPECT_EQ(solution.result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(solution.result.reason,
              testing::EndsWith("; without Lettuce 1 there would be a way"));
  EXPECT_THAT(solution.names, testing::ElementsAre("Lettuce 1", "Lettuce 2", "Tomato 3"));
  EXPECT_TRUE(solution.frames.empty());
}

TEST(SolveScenario, ThePlannersThresholdIsToldInTheReport) {
  const Scenario scenario = shipped("infeasible-0001");
  Solution solution = solveScenario(scenario, shippedModel(), BeliefPlanner());
  EXPECT_EQ(reportOf(scenario, shippedModel(), solution, "belief", 0).legality_threshold,
            std::nullopt);
  solution.legality_threshold = 0.02;
  EXPECT_EQ(reportOf(scenario, shippedModel(), solution, "belief", 0).legality_threshold, 0.02);
}

TEST(SolveScenario, FindsTheTargetByItself) {
  Scenario scenario = shipped("level2-0001");
  const Solution told = solveScenario(scenario, shippedModel(), BeliefPlanner());
  scenario.target.reset();
  const Solution found = solveScenario(scenario, shippedModel(), BeliefPlanner());
  EXPECT_EQ(found.problem.initial.target, told.problem.initial.target);
  EXPECT_EQ(found.result.plans, told.result.plans);
}

TEST(SolveScenario, RefusesATargetThatIsHiddenInTheGoal) {
  Scenario scenario = shipped("level1-0001");
  auto& goal = std::get<PictureInput>(scenario.input).goal;
  std::fill(goal.mask.begin(), goal.mask.end(), std::uint8_t{0});
  EXPECT_THAT([&] { solveScenario(scenario, shippedModel(), BeliefPlanner()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("goal picture")));
}

TEST(SolveScenario, SolvesForSeveralTargetsFromPictures) {
  const Scenario scenario = shipped("two-targets/level3x2-0001");
  const Solution solution = solveScenario(scenario, shippedModel(), JointPlanner());
  ASSERT_EQ(solution.result.status, PlanStatus::kSolved) << solution.result.reason;
  EXPECT_EQ(solution.targets.size(), 2u);
  ASSERT_TRUE(solution.evaluation.has_value());
  EXPECT_TRUE(solution.evaluation->best.succeeded());
  const Plan& best = solution.result.plans.front();
  EXPECT_EQ(best.moved.size(), best.actions.size());
  EXPECT_EQ(solution.frames.size(), best.actions.size());
  const Report report = reportOf(scenario, shippedModel(), solution, "astar", 0);
  EXPECT_EQ(report.frames.size(), best.actions.size());
  EXPECT_THAT(renderReport(report), testing::HasSubstr("targets are round"));
  EXPECT_THAT([&] { solveScenario(scenario, shippedModel(), BeliefPlanner()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("targets: several targets")));
  EXPECT_THROW(solveScenario(shipped("level1-0001"), shippedModel(), JointPlanner()),
               std::invalid_argument);
}

TEST(SolveScenario, NamesTargetsAsTheReportDoes) {
  Scenario scenario = shipped("two-targets/level3x2-0001");
  const Solution solution = solveScenario(scenario, shippedModel(), JointPlanner());
  SymbolInput symbols;
  for (const SymbolBelief& belief : solution.problem.initial.objects) {
    symbols.objects.push_back(given(belief));
  }
  for (const TargetGoal& target : solution.targets) symbols.goals.push_back(given(target.goal));
  for (const Concept which : {Concept::kPositionX, Concept::kPositionY}) {
    symbols.goals[1][index(which)] = symbols.goals[0][index(which)];
  }
  scenario.input = symbols;
  const Solution none = solveScenario(scenario, shippedModel(), JointPlanner());
  EXPECT_EQ(none.names, solution.names);
  EXPECT_THAT(none.result.reason,
              testing::HasSubstr("the goals of " + none.names[none.targets[0].object] + " and " +
                                 none.names[none.targets[1].object] + " rule each other out"));
  const std::string page = renderReport(reportOf(scenario, shippedModel(), none, "astar", 0));
  for (const std::string& name : none.names) EXPECT_THAT(page, testing::HasSubstr(name));
}

TEST(SolveScenario, NamesObjectsThatAreGuesses) {
  const Scenario scenario = shipped("level1-0001");
  std::size_t doubts = 0;
  for (const std::size_t width : {1u, 4u, 1000u}) {  // of stripes that no object of the set has
    Scenario striped = scenario;
    RgbdImage& initial = std::get<PictureInput>(striped.input).initial;
    for (std::size_t i = 0; i < initial.mask.size(); ++i) {
      if (initial.mask[i] != *scenario.target) continue;
      const bool bright = i / width % 2 == 1;
      for (std::size_t k = 0; k < 3; ++k) initial.rgb[3 * i + k] = bright && k < 2 ? 255 : 0;
    }
    const Solution solution = solveScenario(striped, shippedModel(), BeliefPlanner());
    const std::string name = solution.names[solution.problem.initial.target];
    for (const std::string& doubt : solution.doubts) {
      ++doubts;
      EXPECT_THAT(doubt,
                  testing::AnyOf(testing::HasSubstr(" of " + name + " is like none"),
                                 testing::HasSubstr(name + " does not look like what it is")));
    }
  }
  EXPECT_GT(doubts, 0u);
}

/// A phone that is turned half around; seen alone, its front is a guess.
TEST(SolveScenario, TellsOfATurnThatWasMeasured) {
  Renderer renderer;
  Scenario scenario = shipped("level1-0001");
  scenario.target = 1;
  scenario.reference.reset();
  std::size_t told = 0;
  for (int rotation = 0; rotation < 4; ++rotation)
    for (int color = 0; color < 3; ++color) {
      World before, after;
      before.objects = {{ObjectType::kCellphone, {0, 1}, rotation, color, 3}};
      after.objects = {{ObjectType::kCellphone, {2, 2}, (rotation + 2) % 4, color, 3}};
      auto& pictures = std::get<PictureInput>(scenario.input);
      pictures.initial = renderer.render(before, {5, {}});
      pictures.goal = renderer.render(after, {5, {}});
      const bool turned =
          shippedModel().readTask(pictures.initial, pictures.goal).turned_round.front();
      const Solution solution =
          solveScenario(scenario, shippedModel(), BeliefPlanner(), {0, false, {}});
      const auto sentence = testing::HasSubstr("How " + solution.names.front() +
                                               " was turned between the pictures was measured");
      if (turned)
        EXPECT_THAT(solution.doubts, testing::Contains(sentence));
      else
        EXPECT_THAT(solution.doubts, testing::Not(testing::Contains(sentence)));
      told += turned ? 1 : 0;
    }
  EXPECT_GT(told, 0u);
}

TEST(SolveScenario, RefusesOneOfSeveralTargetsThatIsHiddenInTheGoal) {
  Scenario scenario = shipped("two-targets/level3x2-0001");
  auto& goal = std::get<PictureInput>(scenario.input).goal;
  std::replace(goal.mask.begin(), goal.mask.end(), scenario.targets[1], std::uint8_t{0});
  EXPECT_THAT([&] { solveScenario(scenario, shippedModel(), JointPlanner()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("goal picture")));
}

}  // namespace
}  // namespace conceptplan
