#include <gtest/gtest.h>

#include <numeric>

#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

ActionDescription descriptionOf(Action action) {
  SymbolicModel model = testing::tinyModel();
  model.grounding.names[index(Concept::kType)] = {"Cup", "Dyer"};
  return describe(model)[index(action)];
}

TEST(ModelDescription, TellsContextsInWhichAnActionIsNeverTaken) {
  EXPECT_EQ(descriptionOf(Action::kMoveRight).needs, "own POSITION_X is not POSITION_X 2");
  EXPECT_EQ(descriptionOf(Action::kRotateLeft).needs, "nothing");
}

TEST(ModelDescription, TellsChangesOfTheOwnSymbol) {
  EXPECT_EQ(descriptionOf(Action::kMoveLeft).does,
            "POSITION_X: POSITION_X 1 -> POSITION_X 0, POSITION_X 2 -> POSITION_X 1");
  EXPECT_EQ(descriptionOf(Action::kMoveBack).does, "nothing");
}

TEST(ModelDescription, TellsSymbolsTakenFromAnotherObject) {
  const ActionDescription description = descriptionOf(Action::kChangeColor);
  EXPECT_EQ(description.needs, "a Dyer on the workbench");
  EXPECT_EQ(description.does, "COLOR becomes that of the nearest Dyer");
}

TEST(ModelDescription, GivesTheMeanProbabilityOfTheMostProbableEffect) {
  EXPECT_DOUBLE_EQ(descriptionOf(Action::kMoveLeft).probability, 1);
  EXPECT_DOUBLE_EQ(descriptionOf(Action::kRotateLeft).probability, 0.9);
}

/// What change_color of the tiny model needs if its legality depends on where the nearest dyer is.
std::string needsOf(const std::vector<double>& share, const std::vector<std::size_t>& tried) {
  SymbolicModel model = testing::tinyModel();
  model.grounding.names[index(Concept::kType)] = {"Cup", "Dyer"};
  const ContextFeature offset{ContextKind::kNearestOffset, Concept::kType, SymbolId{1}};
  LegalityTable table;
  table[index(Action::kChangeColor)] = {{offset, share}};
  model.legality = ActionLegality(model.cardinality(), table);
  ContextCounts counts{{offset}, {}};
  for (const std::size_t value : tried) counts.rows[value] = {1, 1};
  model.evidence.legality[index(Action::kChangeColor)] = {counts};
  const std::string needs = describe(model)[index(Action::kChangeColor)].needs;
  const std::string always = "a Dyer on the workbench; ";
  EXPECT_TRUE(needs.starts_with(always)) << needs;
  return needs.substr(always.size());
}

/// Offsets are numbered from (-2, -2), rows of five: (0, -1) is 7, (0, 0) is 12, (0, 1) is 17.
TEST(ModelDescription, TellsPlacesBesideAnObjectInWords) {
  std::vector<double> share(26, 0.001);
  for (const std::size_t value : {7, 11, 13, 17}) share[value] = 0.4;
  share[12] = share[25] = ActionLegality::kPriorShare;
  EXPECT_EQ(needsOf(share, {0, 7, 11, 13, 17}), "only beside the nearest Dyer (untried: (0, 0))");
  EXPECT_EQ(needsOf(share, {0, 7, 11, 12, 13, 17}),
            "offset to the nearest Dyer is (0, -1) or (-1, 0) or (0, 0) or (1, 0) or (0, 1)");
  share[12] = share[13] = share[17] = 0.001;
  EXPECT_EQ(needsOf(share, {7, 11}), "the nearest Dyer is a row nearer or a column to the left");
}

TEST(ModelDescription, TellsPlacesInWhichAnActionIsNeverTaken) {
  std::vector<double> share(26, 0.2);
  share[17] = 0;
  std::vector<std::size_t> tried(25);
  std::iota(tried.begin(), tried.end(), std::size_t{0});
  EXPECT_EQ(needsOf(share, tried), "the nearest Dyer is not a row farther");
  share[10] = 0;  // (-2, 0) stands for all that is farther to the left
  EXPECT_EQ(needsOf(share, tried), "offset to the nearest Dyer is not (-2 or less, 0) or (0, 1)");
  for (const std::size_t value : {7, 11, 13}) share[value] = 0;
  share[10] = 0.2;
  EXPECT_EQ(needsOf(share, tried), "not beside the nearest Dyer");
}

TEST(ModelDescription, TellsWhichSymbolsOfAnotherObjectWereSeenTaken) {
  SymbolicModel model = testing::tinyModel();
  model.grounding.names[index(Concept::kType)] = {"Cup", "Dyer"};
  const ContextFeature color{ContextKind::kNearestSymbol, Concept::kColor, SymbolId{1}};
  const auto does = [&](std::map<std::size_t, std::vector<double>> rows) {
    EffectTable effects;
    effects[index(Action::kChangeColor)][index(Concept::kColor)] = {{color}, std::move(rows), 1};
    model.transitions = TransitionModel(model.cardinality(), effects);
    return describe(model)[index(Action::kChangeColor)].does;
  };
  EXPECT_EQ(does({{0, {1, 0}}}), "COLOR becomes that of the nearest Dyer (seen: COLOR 0)");
  EXPECT_EQ(does({{0, {0, 1}}, {1, {1, 0}}}),
            "COLOR by COLOR of the nearest Dyer: COLOR 0 -> COLOR 1, COLOR 1 -> COLOR 0");
  EXPECT_EQ(does({}), "nothing");
}

}  // namespace
}  // namespace conceptplan
