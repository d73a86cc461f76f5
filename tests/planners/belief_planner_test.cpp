#include "conceptplan/planners/belief_planner.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "conceptplan/planners/belief_update.hpp"
#include "planners/learned_world.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using testing::tinyModel;
using testing::tinyProblem;
using testing::tinySymbols;

/// Start and goal of the tiny world, seen unclearly.
SymbolicProblem unclearProblem() {
  SymbolicProblem problem = tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0));
  SymbolBelief& start = problem.initial.objects.front();
  start[index(Concept::kPositionX)] = {0.7, 0.2, 0.1};
  start[index(Concept::kRotation)] = {0.6, 0.4};
  problem.goal[index(Concept::kPositionX)] = {0.05, 0.15, 0.8};
  problem.goal[index(Concept::kRotation)] = {0.3, 0.7};
  return problem;
}

/// Pr[goal, every step legal] of a sequence in the tiny world by summing over all state paths,
/// written from the model's tables alone.
double summedProbability(const SymbolicModel& model, const SymbolicProblem& problem,
                         const ActionSequence& actions, std::size_t step, const Symbols& state) {
  if (step == actions.size()) {
    return problem.goal[index(Concept::kPositionX)][index(state[index(Concept::kPositionX)])] *
           problem.goal[index(Concept::kRotation)][index(state[index(Concept::kRotation)])];
  }
  const Surroundings surroundings{model.grounding, state, {}};
  const Action action = actions[step];
  if (!model.transitions.isDefined(action, surroundings) ||
      model.legality.probability(action, surroundings) <= 0.01) {
    return 0;
  }
  const auto x = model.transitions.distribution(action, Concept::kPositionX, surroundings);
  const auto r = model.transitions.distribution(action, Concept::kRotation, surroundings);
  double sum = 0;
  for (int column = 0; column < 3; ++column) {
    for (int rotation = 0; rotation < 2; ++rotation) {
      const double probability =
          x[static_cast<std::size_t>(column)] * r[static_cast<std::size_t>(rotation)];
      if (probability == 0) continue;
      sum += probability * summedProbability(model, problem, actions, step + 1,
                                             tinySymbols(0, column, rotation, 0));
    }
  }
  return sum;
}

double summedProbability(const SymbolicModel& model, const SymbolicProblem& problem,
                         const ActionSequence& actions) {
  const SymbolBelief& start = problem.initial.objects.front();
  double sum = 0;
  for (int column = 0; column < 3; ++column) {
    for (int rotation = 0; rotation < 2; ++rotation) {
      sum += start[index(Concept::kPositionX)][static_cast<std::size_t>(column)] *
             start[index(Concept::kRotation)][static_cast<std::size_t>(rotation)] *
             summedProbability(model, problem, actions, 0, tinySymbols(0, column, rotation, 0));
    }
  }
  return sum;
}

/// Every sequence of the three actions that do something alone on the bench.
void enumerate(std::size_t longest, ActionSequence& prefix,
               const std::function<void(const ActionSequence&)>& visit) {
  visit(prefix);
  if (prefix.size() == longest) return;
  for (const Action action : {Action::kMoveLeft, Action::kMoveRight, Action::kRotateLeft}) {
    prefix.push_back(action);
    enumerate(longest, prefix, visit);
    prefix.pop_back();
  }
}

PlanQuery query(std::size_t top, std::size_t horizon = 24) {
  PlanQuery wanted;
  wanted.top = top;
  wanted.limits.horizon = horizon;
  return wanted;
}

TEST(BeliefPlanner, Eqs4To6RankLikeFullEnumeration) {
  const SymbolicModel model = tinyModel();
  const SymbolicProblem problem = unclearProblem();
  BeliefPlannerOptions options;
  options.alternatives = Alternatives::kPaths;
  options.min_hypothesis = 0;
  constexpr std::size_t kHorizon = 6;
  constexpr std::size_t kTop = 20;
  const PlanResult result =
      BeliefPlanner(options).solve(compile(model, problem, GridValidity()), query(kTop, kHorizon));
  ASSERT_EQ(result.status, PlanStatus::kSolved);

  std::vector<double> scores;
  ActionSequence prefix;
  enumerate(kHorizon, prefix, [&](const ActionSequence& actions) {
    scores.push_back(summedProbability(model, problem, actions) *
                     std::pow(1 - options.step_discount, actions.size()));
  });
  std::sort(scores.rbegin(), scores.rend());
  ASSERT_THAT(result.plans, SizeIs(kTop));
  for (std::size_t i = 0; i < kTop; ++i) {
    EXPECT_NEAR(std::exp(-result.plans[i].cost), scores[i], 1e-9) << "plan " << i;
    EXPECT_NEAR(result.plans[i].probability,
                summedProbability(model, problem, result.plans[i].actions), 1e-9);
  }
}

TEST(BeliefPlanner, TheBestPlanIsTheBestOfAllWithAlternativesToo) {
  const SymbolicModel model = tinyModel();
  const SymbolicProblem problem = unclearProblem();
  const PlanResult result =
      BeliefPlanner().solve(compile(model, problem, GridValidity()), query(5, 6));
  double best = 0;
  ActionSequence prefix;
  enumerate(6, prefix, [&](const ActionSequence& actions) {
    best =
        std::max(best, summedProbability(model, problem, actions) * std::pow(0.99, actions.size()));
  });
  ASSERT_THAT(result.plans, SizeIs(5));
  EXPECT_NEAR(std::exp(-result.plans.front().cost), best, 1e-9);
}

TEST(BeliefPlanner, StartEqualsGoalGivesTheEmptyPlan) {
  const Symbols symbols = tinySymbols(0, 1, 0, 0);
  const PlanResult result = BeliefPlanner().solve(
      compile(tinyModel(), tinyProblem(symbols, symbols), GridValidity()), query(1));
  ASSERT_THAT(result.plans, SizeIs(1));
  EXPECT_THAT(result.plans.front().actions, IsEmpty());
  EXPECT_DOUBLE_EQ(result.plans.front().probability, 1);
}

TEST(BeliefPlanner, AWanderingPlanNeedsItsDiscountMoreProbability) {
  // Turning twice gains nothing; a second try after a slip gains much and is taken.
  const SymbolicProblem problem = tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 0, 1, 0));
  const SymbolGraph graph = compile(tinyModel(), problem, GridValidity());
  const PlanResult result = BeliefPlanner().solve(graph, query(1));
  ASSERT_THAT(result.plans, SizeIs(1));
  EXPECT_THAT(result.plans.front().actions, ElementsAre(Action::kRotateLeft));
}

TEST(BeliefPlanner, AlternativesCoverOtherReadingsOfThePictures) {
  const testing::Relabelling& labels = testing::learnedRelabelling();
  Task task;
  task.initial.objects = {{ObjectType::kCup, {0, 0}, 0, 0, 0}};
  task.goal = {ObjectType::kCup, {2, 3}, 1, 0, 0};
  SymbolicProblem problem = labels.problem(task);
  std::vector<double>& rotation = problem.goal[index(Concept::kRotation)];
  rotation.assign(4, 0);
  rotation[index(labels.symbol(Concept::kRotation, 1))] = 0.55;
  rotation[index(labels.symbol(Concept::kRotation, 3))] = 0.45;
  const SymbolGraph graph = compile(testing::learnedModel(), problem, GridValidity());

  const auto turns = [&](Alternatives alternatives, Action turn) {
    BeliefPlannerOptions options;
    options.alternatives = alternatives;
    const PlanResult result = BeliefPlanner(options).solve(graph, query(5));
    EXPECT_THAT(result.plans, SizeIs(5));
    return std::count_if(result.plans.begin(), result.plans.end(), [&](const Plan& plan) {
      return std::count(plan.actions.begin(), plan.actions.end(), turn) > 0;
    });
  };
  EXPECT_EQ(turns(Alternatives::kOutcomes, Action::kRotateRight), 1);
  EXPECT_EQ(turns(Alternatives::kOutcomes, Action::kRotateLeft), 4);
  EXPECT_EQ(turns(Alternatives::kPaths, Action::kRotateRight), 0);
}

TEST(BeliefPlanner, HardSymbolsPlanForTheMostProbableReading) {
  SymbolicProblem problem = tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 1, 0, 0));
  problem.initial.objects.front()[index(Concept::kPositionX)] = {0.6, 0, 0.4};
  const SymbolGraph graph = compile(tinyModel(), problem, GridValidity());
  BeliefPlannerOptions options;
  options.hard_symbols = true;
  const PlanResult hard = BeliefPlanner(options).solve(graph, query(1));
  EXPECT_DOUBLE_EQ(hard.plans.at(0).probability, 0.8);
  const PlanResult soft = BeliefPlanner().solve(graph, query(1));
  EXPECT_DOUBLE_EQ(soft.plans.at(0).probability, 0.6 * 0.8);
}

TEST(BeliefPlanner, Eq6ConditionalRankingFollowsThePapersLetter) {
  // Seen in column 0 and hardly in 1. Moving left is possible only from 1, so that the scaled
  // belief takes the improbable start for the true one.
  SymbolicProblem problem = tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 0, 0, 0));
  problem.initial.objects.front()[index(Concept::kPositionX)] = {0.9, 0.1, 0};
  const SymbolGraph graph = compile(tinyModel(), problem, GridValidity());
  EXPECT_THAT(BeliefPlanner().solve(graph, query(1)).plans.at(0).actions, IsEmpty());
  BeliefPlannerOptions options;
  options.ranking = Ranking::kConditional;
  const Plan literal = BeliefPlanner(options).solve(graph, query(1)).plans.at(0);
  EXPECT_THAT(literal.actions, ElementsAre(Action::kMoveLeft));
  EXPECT_DOUBLE_EQ(literal.probability, 1);
}

TEST(BeliefPlanner, AConceptThatNothingHereChangesIsNamed) {
  const PlanResult result = BeliefPlanner().solve(
      compile(tinyModel(), tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 1, 0, 1)),
              GridValidity()),
      query(3));
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.plans, IsEmpty());
  EXPECT_EQ(result.reason, "COLOR must change, and nothing here changes it");
}

TEST(BeliefPlanner, AColourReadWronglyIsOvercomeByTheNextReading) {
  SymbolicProblem problem = tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 1, 0, 1));
  problem.goal[index(Concept::kColor)] = {0.1, 0.9};
  const PlanResult result =
      BeliefPlanner().solve(compile(tinyModel(), problem, GridValidity()), query(1));
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.plans.at(0).actions, ElementsAre(Action::kMoveRight));
  EXPECT_NEAR(result.plans.at(0).probability, 0.08, 1e-12);
  EXPECT_THAT(result.reason, HasSubstr("less probable reading"));
}

TEST(BeliefPlanner, ATypeReadTwoWaysIsNoObstacle) {
  const PlanResult result = BeliefPlanner().solve(
      compile(tinyModel(), tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(1, 1, 0, 0)),
              GridValidity()),
      query(1));
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_DOUBLE_EQ(result.plans.at(0).probability, 0.8);
}

TEST(BeliefPlanner, AWallIsTracedToTheObjectThatMakesIt) {
  SymbolicProblem problem = tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 0, 0));
  problem.initial.objects.insert(problem.initial.objects.begin(),
                                 certain(tinySymbols(0, 1, 0, 0), testing::kTinyCardinality));
  problem.initial.target = 1;
  const PlanResult result =
      BeliefPlanner().solve(compile(tinyModel(), problem, GridValidity()), query(1));
  EXPECT_EQ(result.status, PlanStatus::kInfeasible);
  EXPECT_THAT(result.reason, HasSubstr("no legal and valid steps lead to the goal"));
  const auto wall = std::find_if(
      result.rejections.begin(), result.rejections.end(),
      [](const Rejection& rejection) { return rejection.cause == Invalidity::kCollision; });
  ASSERT_NE(wall, result.rejections.end());
  EXPECT_EQ(wall->action, Action::kMoveRight);
  EXPECT_EQ(wall->object, 0u);
  const auto illegal = std::find_if(
      result.rejections.begin(), result.rejections.end(),
      [](const Rejection& rejection) { return rejection.action == Action::kMoveLeft; });
  ASSERT_NE(illegal, result.rejections.end());
  EXPECT_EQ(illegal->cause, Invalidity::kNone);
  EXPECT_DOUBLE_EQ(illegal->value, 0);
}

TEST(BeliefPlanner, ADyerThatIsHardlyRecognisedIsUsedWhereTheColourMustChange) {
  SymbolicProblem problem = tinyProblem(tinySymbols(0, 1, 0, 0), tinySymbols(0, 1, 0, 1));
  problem.initial.objects.push_back(certain(tinySymbols(1, 2, 0, 1), testing::kTinyCardinality));
  problem.initial.objects[1][index(Concept::kType)] = {0.7, 0.3};
  const SymbolGraph graph = compile(tinyModel(), problem, GridValidity());
  const PlanResult result = BeliefPlanner().solve(graph, query(1));
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.plans.at(0).actions, ElementsAre(Action::kChangeColor));
  EXPECT_NEAR(result.plans.at(0).probability, 0.3, 1e-12);
  EXPECT_THAT(result.plans.at(0).predicted, ElementsAre(tinySymbols(0, 1, 0, 1)));
  BeliefPlannerOptions options;
  options.hard_symbols = true;
  EXPECT_EQ(BeliefPlanner(options).solve(graph, query(1)).status, PlanStatus::kInfeasible);
}

TEST(BeliefPlanner, PredictsTheMostProbableSymbolsAfterEachStep) {
  const PlanResult result = BeliefPlanner().solve(
      compile(tinyModel(), tinyProblem(tinySymbols(0, 2, 0, 0), tinySymbols(0, 0, 0, 0)),
              GridValidity()),
      query(1));
  EXPECT_THAT(result.plans.at(0).predicted,
              ElementsAre(tinySymbols(0, 1, 0, 0), tinySymbols(0, 0, 0, 0)));
}

TEST(BeliefPlanner, ALimitLeavesTheBestPlansFoundSoFar) {
  PlanQuery wanted = query(5);
  wanted.limits.max_expansions = 12;
  const PlanResult result =
      BeliefPlanner().solve(compile(tinyModel(), unclearProblem(), GridValidity()), wanted);
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_THAT(result.plans, ::testing::Not(IsEmpty()));
  EXPECT_GT(result.plans.front().probability, 0.1);
  EXPECT_EQ(result.reason, "stopped at the limit of 12 expansions; the best plans found so far");
}

TEST(BeliefPlanner, RefusesOptionsOutOfRange) {
  BeliefPlannerOptions options;
  options.step_discount = 0.7;
  EXPECT_THAT([&] { BeliefPlanner planner(options); },
              ::testing::ThrowsMessage<std::invalid_argument>(HasSubstr("step_discount is 0.7")));
}

}  // namespace
}  // namespace conceptplan
