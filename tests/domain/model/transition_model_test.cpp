#include "conceptplan/domain/model/transition_model.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::kTinyCardinality;
using ::testing::ThrowsMessage;
using testing::tinySymbols;

TEST(TransitionModel, GivesTheRowOfTheContext) {
  const SymbolicModel model = testing::tinyModel();
  EXPECT_THAT(model.transitions.distribution(Action::kMoveRight, Concept::kPositionX,
                                             {model.grounding, tinySymbols(0, 1, 0, 0), {}}),
              ElementsAre(0, 0.2, 0.8));
}

TEST(TransitionModel, AnUnseenContextLeavesTheSymbol) {
  const SymbolicModel model = testing::tinyModel();
  EXPECT_THAT(model.transitions.distribution(Action::kMoveRight, Concept::kPositionX,
                                             {model.grounding, tinySymbols(0, 2, 0, 0), {}}),
              ElementsAre(0, 0, 1));
}

TEST(TransitionModel, WhatDoesNotStayIsSpreadEvenly) {
  EffectTable effects;
  effects[index(Action::kMoveLeft)][index(Concept::kPositionX)].stays = 0.5;
  const TransitionModel model(kTinyCardinality, effects);
  const SymbolGrounding grounding = testing::tinyModel().grounding;
  EXPECT_THAT(model.distribution(Action::kMoveLeft, Concept::kPositionX,
                                 {grounding, tinySymbols(0, 1, 0, 0), {}}),
              ElementsAre(0.25, 0.5, 0.25));
  EXPECT_TRUE(model.changes(Concept::kPositionX, 0.1));
}

TEST(TransitionModel, TakesSymbolsFromOtherObjects) {
  const SymbolicModel model = testing::tinyModel();
  const std::vector<Symbols> dyer{tinySymbols(1, 2, 0, 1)};
  const Surroundings beside{model.grounding, tinySymbols(0, 1, 0, 0), dyer};
  EXPECT_THAT(model.transitions.distribution(Action::kChangeColor, Concept::kColor, beside),
              ElementsAre(0, 1));
  EXPECT_TRUE(model.transitions.isDefined(Action::kChangeColor, beside));
}

TEST(TransitionModel, IsNotDefinedWithoutTheObjectThatTheEffectTakesFrom) {
  const SymbolicModel model = testing::tinyModel();
  const Surroundings alone{model.grounding, tinySymbols(0, 1, 0, 0), {}};
  EXPECT_FALSE(model.transitions.isDefined(Action::kChangeColor, alone));
  EXPECT_TRUE(model.transitions.isDefined(Action::kMoveLeft, alone));
}

TEST(TransitionModel, KnowsWhichConceptsActionsChange) {
  const TransitionModel model = testing::tinyModel().transitions;
  EXPECT_TRUE(model.changes(Concept::kPositionX, 1e-3));
  EXPECT_TRUE(model.changes(Concept::kRotation, 1e-3));
  EXPECT_TRUE(model.changes(Concept::kColor, 1e-3));
  EXPECT_FALSE(model.changes(Concept::kType, 1e-3));
  EXPECT_FALSE(model.changes(Concept::kSize, 1e-3));
}

TEST(TransitionModel, RefusesRowsThatAreNoDistributions) {
  const auto make = [](std::map<std::size_t, std::vector<double>> rows) {
    EffectTable effects;
    effects[index(Action::kMoveLeft)][index(Concept::kPositionX)] = {
        {{ContextKind::kOwnSymbol, Concept::kPositionX, SymbolId{0}}}, std::move(rows), 1};
    return TransitionModel(kTinyCardinality, effects);
  };
  EXPECT_THAT(
      [&] {
        make({{0, {0.5, 0.5}}});
      },
      ThrowsMessage<std::invalid_argument>(
          "effect of move_left on POSITION_X: a row has 2 symbols, expected 3"));
  EXPECT_THAT(
      [&] {
        make({{0, {0.5, 0.4, 0}}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("a row sums to 0.9")));
  EXPECT_THAT(
      [&] {
        make({{0, {1.5, -0.5, 0}}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("probability -0.5")));
  EXPECT_THAT(
      [&] {
        make({{3, {1, 0, 0}}});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("context value 3 is out of range")));
}

TEST(ContextCounts, CountsEachOutcomeOfEachContext) {
  ContextCounts counts;
  counts.add(4, 1, 3);
  counts.add(4, 1, 3);
  counts.add(4, 2, 3);
  counts.add(0, 0, 3);
  EXPECT_THAT(counts.rows.at(4), ElementsAre(0, 2, 1));
  EXPECT_THAT(counts.rows.at(0), ElementsAre(1, 0, 0));
}

}  // namespace
}  // namespace conceptplan
