#include "half_turn.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "conceptplan/domain/rendering/renderer.hpp"
#include "conceptplan/pipeline/model_manifest.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kRotation = index(Concept::kRotation);

SymbolicModel learnedModel() {
  return readSymbolicModel(std::filesystem::path(CONCEPTPLAN_SHIPPED_MODEL) / kTransitionsFile);
}

/// The same model, in which turning left does nothing.
SymbolicModel modelThatDoesNotTurn() {
  const SymbolicModel model = learnedModel();
  EffectTable effects;
  for (const Action action : kActions)
    for (const Concept which : kConcepts)
      effects[index(action)][index(which)] = model.transitions.effect(action, which);
  effects[index(Action::kRotateLeft)][kRotation] = {};
  return {model.grounding, TransitionModel(model.cardinality(), effects), model.legality,
          model.evidence};
}

/// The symbols by their names in the model.
SymbolBelief beliefIn(const SymbolicModel& model, Cell cell, const std::string& rotation) {
  const auto symbolOf = [](const auto& values, const auto& value) {
    return SymbolId{static_cast<std::int32_t>(std::ranges::find(values, value) - values.begin())};
  };
  Symbols symbols{};
  symbols[index(Concept::kPositionX)] = symbolOf(model.grounding.columns, cell.x);
  symbols[index(Concept::kPositionY)] = symbolOf(model.grounding.rows, cell.y);
  symbols[kRotation] = symbolOf(model.grounding.names[kRotation], rotation);
  return certain(symbols, model.cardinality());
}

/// A sponge, whose pad lies over one half, turned from 90 to 180 degrees and moved.
class HalfTurn : public testing::Test {
 protected:
  RgbdImage picture(Cell cell, int rotation) {
    World world;
    world.objects = {{ObjectType::kDishSponge, cell, rotation, 1, 3}};
    return renderer_.render(world, {3, {}});
  }

  bool isTurnedRoundIf(const SymbolicModel& model, const std::string& before,
                       const std::string& after) {
    const RgbdImage first = picture({0, 1}, 1), second = picture({2, 3}, 2);
    return isTurnedRound(model, {first, 1, beliefIn(model, {0, 1}, before)},
                         {second, 1, beliefIn(model, {2, 3}, after)});
  }

  Renderer renderer_;
};

TEST_F(HalfTurn, IsFoundWhereOneOfTheTwoIsReadAsItsOpposite) {
  const SymbolicModel model = learnedModel();
  EXPECT_FALSE(isTurnedRoundIf(model, "90 degrees", "180 degrees"));
  EXPECT_TRUE(isTurnedRoundIf(model, "90 degrees", "0 degrees"));
  EXPECT_TRUE(isTurnedRoundIf(model, "270 degrees", "180 degrees"));
  EXPECT_FALSE(isTurnedRoundIf(model, "270 degrees", "0 degrees"));  // turned alike, that matters
}

TEST_F(HalfTurn, IsNotFoundWhereTheModelLeadsFromNoRotationToTheOther) {
  const SymbolicModel model = modelThatDoesNotTurn();
  EXPECT_FALSE(isTurnedRoundIf(model, "90 degrees", "0 degrees"));
  const RgbdImage first = picture({0, 1}, 1), second = picture({2, 3}, 3);
  const SymbolBelief before = beliefIn(model, {0, 1}, "90 degrees");
  const SymbolBelief after = beliefIn(model, {2, 3}, "90 degrees");  // misread
  EXPECT_TRUE(isTurnedRound(learnedModel(), {first, 1, before}, {second, 1, after}));
  EXPECT_FALSE(isTurnedRound(model, {first, 1, before}, {second, 1, after}));
  EXPECT_EQ(turnedRound(model, after), after);
}

TEST_F(HalfTurn, MovesTheBeliefByWhatWasLearned) {
  const SymbolicModel model = learnedModel();
  SymbolBelief belief = beliefIn(model, {1, 1}, "90 degrees");
  const SymbolBelief opposite = beliefIn(model, {1, 1}, "270 degrees");
  for (std::size_t symbol = 0; symbol < belief[kRotation].size(); ++symbol)
    belief[kRotation][symbol] =
        0.75 * belief[kRotation][symbol] + 0.25 * opposite[kRotation][symbol];
  const SymbolBelief turned = turnedRound(model, belief);
  for (std::size_t symbol = 0; symbol < belief[kRotation].size(); ++symbol)
    EXPECT_NEAR(turned[kRotation][symbol],
                belief[kRotation][symbol] == 0 ? 0 : 1 - belief[kRotation][symbol], 1e-12);
  EXPECT_EQ(turnedRound(model, turned), belief);
  belief[kRotation] = turned[kRotation];
  EXPECT_EQ(belief, turned);  // no other concept
}

}  // namespace
}  // namespace conceptplan
