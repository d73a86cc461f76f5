#include "conceptplan/domain/symbols.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace conceptplan {
namespace {

TEST(Symbols, MostProbableUndoesCertain) {
  const Symbols symbols{SymbolId{7}, SymbolId{2}, SymbolId{0},
                        SymbolId{3}, SymbolId{5}, SymbolId{1}};
  const SymbolBelief belief = certain(symbols, kConceptCardinality);
  EXPECT_EQ(mostProbable(belief), symbols);
  for (std::size_t i = 0; i < kNumConcepts; ++i) {
    EXPECT_EQ(belief[i].size(), kConceptCardinality[i]);
    EXPECT_EQ(belief[i][index(symbols[i])], 1.0);
  }
}

TEST(Symbols, TiesGoToTheLowerNumber) {
  SymbolBelief belief;
  belief.fill({0.2, 0.4, 0.4});
  EXPECT_EQ(mostProbable(belief)[0], SymbolId{1});
}

TEST(Symbols, ABeliefNeedsSymbols) {
  SymbolBelief belief;
  belief.fill({1.0});
  belief[4].clear();
  EXPECT_THAT([&] { mostProbable(belief); },
              testing::ThrowsMessage<std::invalid_argument>("the belief of COLOR has no symbols"));
}

TEST(Symbols, ASymbolIsBelowItsCardinality) {
  Symbols symbols{};
  symbols[1] = SymbolId{3};
  EXPECT_THAT(
      [&] { certain(symbols, kConceptCardinality); },
      testing::ThrowsMessage<std::invalid_argument>("symbol 3 of POSITION_X is not in [0, 3)"));
  symbols[1] = SymbolId{-1};
  EXPECT_THROW(certain(symbols, kConceptCardinality), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
