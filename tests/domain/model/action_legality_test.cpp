#include "conceptplan/domain/model/action_legality.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using testing::kTinyCardinality;
using testing::tinySymbols;

TEST(ActionLegality, IsTheLeastOfItsFactors) {
  LegalityTable table;
  table[index(Action::kRotateLeft)] = {
      {{ContextKind::kOwnSymbol, Concept::kPositionX, SymbolId{0}}, {0.5, 0.2, 0.3}},
      {{ContextKind::kOwnSymbol, Concept::kColor, SymbolId{0}}, {0.4, 0.1}}};
  const ActionLegality legality(kTinyCardinality, table);
  const SymbolGrounding grounding = testing::tinyModel().grounding;
  const auto at = [&](int column, int color) {
    return legality.probability(Action::kRotateLeft,
                                {grounding, tinySymbols(0, column, 0, color), {}});
  };
  EXPECT_DOUBLE_EQ(at(0, 0), 0.4);
  EXPECT_DOUBLE_EQ(at(1, 0), 0.2);
  EXPECT_DOUBLE_EQ(at(1, 1), 0.1);
}

TEST(ActionLegality, WithoutFactorsIsThePrior) {
  const ActionLegality legality(kTinyCardinality, {});
  const SymbolGrounding grounding = testing::tinyModel().grounding;
  EXPECT_DOUBLE_EQ(
      legality.probability(Action::kMoveBack, {grounding, tinySymbols(0, 0, 0, 0), {}}), 1.0 / 7);
}

TEST(ActionLegality, RefusesSharesThatDoNotFit) {
  const auto make = [](std::vector<double> share) {
    LegalityTable table;
    table[index(Action::kMoveLeft)] = {
        {{ContextKind::kOwnSymbol, Concept::kPositionX, SymbolId{0}}, std::move(share)}};
    return ActionLegality(kTinyCardinality, table);
  };
  EXPECT_THAT(
      [&] {
        make({0.5, 0.5});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(
          "legality of move_left: a factor has 2 shares, expected 3"));
  EXPECT_THAT(
      [&] {
        make({0.5, 0.5, 1.5});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("share 1.5")));
}

}  // namespace
}  // namespace conceptplan
