#include "conceptplan/planners/symbol_graph.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;
using ::testing::ThrowsMessage;
using testing::tinyModel;
using testing::tinyProblem;
using testing::tinySymbols;

SymbolicProblem withDyer() {
  SymbolicProblem problem = tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 1, 0, 1));
  problem.initial.objects.push_back(certain(tinySymbols(1, 2, 0, 1), testing::kTinyCardinality));
  return problem;
}

TEST(SymbolGraph, StatesPackTheConceptsThatActionsChange) {
  const SymbolGraph graph = compile(tinyModel(), withDyer(), GridValidity());
  EXPECT_EQ(graph.numStates(), 3u * 2 * 2);
  for (std::size_t i = 0; i < graph.numStates(); ++i) {
    const auto state = static_cast<StateId>(i);
    EXPECT_EQ(graph.state(graph.symbols(state)), state);
  }
  EXPECT_EQ(graph.symbols(graph.mostProbableStart()), tinySymbols(0, 0, 0, 0));
  EXPECT_EQ(graph.symbols(graph.mostProbableGoal()), tinySymbols(0, 1, 0, 1));
}

TEST(SymbolGraph, WithoutADyerColourIsFrozenHereAndTypeAlways) {
  const SymbolGraph graph = compile(
      tinyModel(), tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 1, 0, 0)), GridValidity());
  EXPECT_EQ(graph.numStates(), 3u * 2);
  EXPECT_EQ(graph.mutability(Concept::kColor), Mutability::kFrozenHere);
  EXPECT_EQ(graph.mutability(Concept::kType), Mutability::kNeverChanges);
  EXPECT_EQ(graph.mutability(Concept::kPositionX), Mutability::kChanges);
  EXPECT_EQ(graph.legality(graph.mostProbableStart(), Action::kChangeColor), 0);
}

TEST(SymbolGraph, FrozenAgreementCountsColourButNotType) {
  SymbolicProblem problem = tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(1, 0, 0, 0));
  problem.goal[index(Concept::kColor)] = {0.3, 0.7};
  EXPECT_DOUBLE_EQ(compile(tinyModel(), problem, GridValidity()).frozenAgreement(), 0.3);
}

TEST(SymbolGraph, TransitionsAreDistributionsByFallingProbability) {
  const SymbolGraph graph = compile(tinyModel(), withDyer(), GridValidity());
  for (std::size_t i = 0; i < graph.numStates(); ++i) {
    for (const Action action : kActions) {
      double sum = 0;
      double last = 1;
      for (const Transition& transition : graph.transitions(static_cast<StateId>(i), action)) {
        EXPECT_LE(transition.probability, last);
        EXPECT_DOUBLE_EQ(transition.cost, -std::log(transition.probability));
        last = transition.probability;
        sum += transition.probability;
      }
      EXPECT_NEAR(sum, 1, 1e-12);
    }
  }
}

TEST(SymbolGraph, AnActionWithoutSlipHasOneTransition) {
  const SymbolGraph graph = compile(tinyModel(), withDyer(), GridValidity());
  const auto transitions =
      graph.transitions(graph.state(tinySymbols(0, 1, 0, 0)), Action::kChangeColor);
  ASSERT_THAT(transitions, SizeIs(1));
  EXPECT_EQ(graph.symbols(transitions.front().state), tinySymbols(0, 1, 0, 1));
}

TEST(SymbolGraph, OneCheckServesAllStatesOfACell) {
  const SymbolGraph graph = compile(tinyModel(), withDyer(), GridValidity());
  EXPECT_EQ(graph.validityChecks(), 3u);
  EXPECT_FALSE(graph.valid(graph.state(tinySymbols(0, 2, 1, 0))));
  EXPECT_TRUE(graph.valid(graph.state(tinySymbols(0, 1, 1, 0))));
}

TEST(SymbolGraph, StateBeliefIsTheProductOfTheConcepts) {
  const SymbolGraph graph = compile(tinyModel(), withDyer(), GridValidity());
  SymbolBelief belief = certain(tinySymbols(0, 0, 0, 0), testing::kTinyCardinality);
  belief[index(Concept::kPositionX)] = {0.5, 0.25, 0.25};
  belief[index(Concept::kRotation)] = {0.9, 0.1};
  const std::vector<double> states = graph.stateBelief(belief);
  EXPECT_DOUBLE_EQ(states[index(graph.state(tinySymbols(0, 1, 1, 0)))], 0.025);
  EXPECT_DOUBLE_EQ(std::accumulate(states.begin(), states.end(), 0.0), 1);
}

/// A dyer in column 2, or none there: type 1 with the probability given.
SymbolicProblem withUncertainDyer(double dyer) {
  SymbolicProblem problem = withDyer();
  problem.initial.objects[1][index(Concept::kType)] = {1 - dyer, dyer};
  return problem;
}

TEST(SymbolGraph, CertainObjectsHaveOneReading) {
  const SymbolGraph graph = compile(tinyModel(), withDyer(), GridValidity());
  EXPECT_EQ(graph.numReadings(), 1u);
  EXPECT_EQ(graph.readingShare(0), 1);
}

TEST(SymbolGraph, EachReadingOfTheOtherObjectsHasItsOwnStates) {
  const SymbolGraph graph = compile(tinyModel(), withUncertainDyer(0.3), GridValidity());
  ASSERT_EQ(graph.numReadings(), 2u);
  EXPECT_EQ(graph.numStates(), 2u * 3 * 2 * 2);
  EXPECT_DOUBLE_EQ(graph.readingShare(0), 0.7);
  const StateId beside = graph.state(tinySymbols(0, 1, 0, 0));
  const StateId beside_dyer = graph.inReading(beside, 1);
  EXPECT_EQ(graph.readingOf(beside), 0u);
  EXPECT_EQ(graph.readingOf(beside_dyer), 1u);
  EXPECT_EQ(graph.symbols(beside_dyer), graph.symbols(beside));
  EXPECT_EQ(graph.legality(beside, Action::kChangeColor), 0);
  EXPECT_GT(graph.legality(beside_dyer, Action::kChangeColor), 0);
  for (const Action action : kActions) {
    for (const Transition& transition : graph.transitions(beside_dyer, action)) {
      EXPECT_EQ(graph.readingOf(transition.state), 1u);
    }
  }
}

TEST(SymbolGraph, ReadingsCoverPositionsAndTheSymbolsThatEffectsTake) {
  SymbolicProblem problem = withUncertainDyer(0.9);
  problem.initial.objects[1][index(Concept::kColor)] = {0.2, 0.8};
  problem.initial.objects[1][index(Concept::kPositionX)] = {0, 0.4, 0.6};
  problem.initial.objects[1][index(Concept::kRotation)] = {0.5, 0.5};
  // A dyer of two colours or no dyer, in two columns; its rotation is nobody's concern.
  EXPECT_EQ(compile(tinyModel(), problem, GridValidity()).numReadings(), 6u);
  CompileOptions options;
  options.max_readings = 1;
  EXPECT_EQ(compile(tinyModel(), problem, GridValidity(), options).numReadings(), 1u);
  options.max_readings = 12;
  options.min_reading = 0.3;
  EXPECT_EQ(compile(tinyModel(), problem, GridValidity(), options).numReadings(), 2u);
}

TEST(SymbolGraph, ReadingZeroHasTheMostProbableSymbols) {
  SymbolicProblem problem = withUncertainDyer(0.4);
  problem.initial.objects[1][index(Concept::kPositionX)] = {0, 0.4, 0.6};
  const SymbolGraph graph = compile(tinyModel(), problem, GridValidity());
  EXPECT_FALSE(graph.valid(graph.state(tinySymbols(0, 2, 0, 0))));
  EXPECT_EQ(graph.legality(graph.state(tinySymbols(0, 1, 0, 0)), Action::kChangeColor), 0);
  for (std::size_t i = 2; i < graph.numReadings(); ++i) {
    EXPECT_LE(graph.readingShare(i), graph.readingShare(i - 1));
  }
}

TEST(SymbolGraph, RefusesProblemsThatDoNotFit) {
  const auto compiled = [](const SymbolicProblem& problem) {
    return [problem] { compile(tinyModel(), problem, GridValidity()); };
  };
  SymbolicProblem no_target = withDyer();
  no_target.initial.target = 2;
  EXPECT_THAT(compiled(no_target),
              ThrowsMessage<std::invalid_argument>("the target is object 2 of 2"));
  SymbolicProblem wrong_size = withDyer();
  wrong_size.goal[index(Concept::kPositionX)] = {1};
  EXPECT_THAT(compiled(wrong_size), ThrowsMessage<std::invalid_argument>(
                                        "goal, POSITION_X: expected 3 symbols, found 1"));
  SymbolicProblem no_distribution = withDyer();
  no_distribution.initial.objects[1][index(Concept::kRotation)] = {0.5, 0.6};
  EXPECT_THAT(compiled(no_distribution), ThrowsMessage<std::invalid_argument>(HasSubstr(
                                             "object 1, ROTATION: the probabilities sum to 1.1")));
}

}  // namespace
}  // namespace conceptplan
