#include "symbol_index.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

constexpr ConceptCardinality kCardinality{7, 1000, 3, 1, 2, 641};
constexpr ConceptSet kAll{true, true, true, true, true, true};

TEST(SymbolIndex, EachNumberIsThatOfItsSymbols) {
  const SymbolIndex all(kAll, kCardinality);
  ASSERT_EQ(all.size(), 7u * 1000 * 3 * 2 * 641);
  for (std::size_t number = 0; number < all.size(); number += 97) {
    ASSERT_EQ(all(all.symbols(number, {})), number);
  }
  EXPECT_EQ(all(all.symbols(all.size() - 1, {})), all.size() - 1);
}

// 65,536 x 65,535 numbers: the largest have all 32 bits.
TEST(SymbolIndex, SymbolsOfTheLargestNumbersAreRight) {
  const SymbolIndex two({true, true, true, false, false, false}, {65536, 65535, 1, 1, 1, 1});
  for (std::size_t back = 1; back <= 70'000; ++back) {
    const std::size_t number = two.size() - back;
    const Symbols symbols = two.symbols(number, {});
    ASSERT_EQ(static_cast<std::size_t>(symbols[0]), number % 65536);
    ASSERT_EQ(static_cast<std::size_t>(symbols[1]), number / 65536);
  }
}

TEST(SymbolIndex, VisitsAllInTheOrderOfTheirNumbers) {
  const SymbolIndex some({true, false, true, true, true, false}, kCardinality);
  std::size_t next = 0;
  some.forEach({}, [&](const Symbols& symbols) { ASSERT_EQ(some(symbols), next++); });
  EXPECT_EQ(next, 7u * 3 * 2);
}

TEST(SymbolIndex, AConceptWithOneSymbolIsNotIndexed) {
  const SymbolIndex all(kAll, kCardinality);
  EXPECT_FALSE(all.has(3));
  EXPECT_EQ(all.stride(3), 0u);
  EXPECT_EQ(all.stride(4), 7u * 1000 * 3);
}

}  // namespace
}  // namespace conceptplan
