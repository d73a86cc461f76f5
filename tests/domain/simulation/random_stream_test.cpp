#include "conceptplan/domain/simulation/random_stream.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace conceptplan {
namespace {

TEST(RandomStream, TheSameKeyGivesTheSameDraws) {
  RandomStream a{1, 2};
  RandomStream b{1, 2};
  RandomStream c{2, 1};
  int equal = 0;
  for (int i = 0; i < 100; ++i) {
    const std::size_t draw = a.below(1000);
    EXPECT_EQ(draw, b.below(1000));
    equal += draw == c.below(1000);
  }
  EXPECT_LT(equal, 10);
}

/// Datasets on disk are named by their seeds: these numbers must never change.
TEST(RandomStream, DrawsNeverChangeBetweenVersions) {
  EXPECT_EQ(stableHash({}), 2611923443488327891u);
  EXPECT_EQ(stableHash({1, 2, 3}), 16299856255350999488u);
  RandomStream stream{42};
  EXPECT_EQ(stream.below(1000000), 196528u);
}

TEST(RandomStream, DrawsAreUniform) {
  RandomStream stream{7};
  std::array<int, 7> counts{};
  for (int i = 0; i < 70000; ++i) ++counts[stream.below(7)];
  double chi_squared = 0;
  for (const int count : counts) chi_squared += (count - 10000.0) * (count - 10000.0) / 10000.0;
  EXPECT_LT(chi_squared, 22.5);  // 6 degrees of freedom, p = 0.001
}

TEST(RandomStream, BetweenIncludesBothEnds) {
  RandomStream stream{7};
  std::array<int, 3> counts{};
  for (int i = 0; i < 300; ++i) ++counts.at(static_cast<std::size_t>(stream.between(-1, 1) + 1));
  for (const int count : counts) EXPECT_GT(count, 50);
  EXPECT_EQ(stream.between(4, 4), 4);
}

TEST(RandomStream, NothingCannotBeDrawnFrom) {
  RandomStream stream{7};
  EXPECT_THROW(stream.below(0), std::invalid_argument);
  EXPECT_THROW(stream.between(2, 1), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
