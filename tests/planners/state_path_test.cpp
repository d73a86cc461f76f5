#include "conceptplan/planners/state_path.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

TEST(PathCost, CountsBillionthsOfANat) {
  EXPECT_EQ(toPathCost(1), kNat);
  EXPECT_EQ(toPathCost(1.4e-9), 1);
  EXPECT_EQ(toPathCost(-1.6e-9), -2);
  EXPECT_EQ(toNats(kNat / 4), 0.25);
}

TEST(PathCost, SumsDoNotDependOnTheOrderOfTheirTerms) {
  EXPECT_NE((0.1 + 0.2) + 0.3, 0.1 + (0.2 + 0.3));
  EXPECT_EQ((toPathCost(0.1) + toPathCost(0.2)) + toPathCost(0.3),
            toPathCost(0.1) + (toPathCost(0.2) + toPathCost(0.3)));
}

}  // namespace
}  // namespace conceptplan
