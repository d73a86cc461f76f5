#include "conceptplan/domain/workbench.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

TEST(Workbench, HasThreeColumnsAndFiveRows) {
  const Workbench workbench;
  int cells = 0;
  for (int x = -2; x < 8; ++x)
    for (int y = -2; y < 8; ++y) cells += workbench.contains({x, y});
  EXPECT_EQ(cells, 15);
  EXPECT_TRUE(workbench.contains({2, 4}));
  EXPECT_FALSE(workbench.contains({4, 2}));
}

TEST(Workbench, ItsOriginIsInTheMiddle) {
  const Workbench workbench;
  EXPECT_TRUE(workbench.p_WCell({1, 2}).isApprox(Eigen::Vector2d::Zero()));
  EXPECT_TRUE(workbench.p_WCell({0, 0}).isApprox(Eigen::Vector2d(-0.2, -0.4)));
  EXPECT_TRUE(workbench.p_WCell({2, 4}).isApprox(-workbench.p_WCell({0, 0})));
}

TEST(Workbench, NeighboursAreACellApart) {
  const Workbench workbench{4, 6, 0.1};
  EXPECT_NEAR((workbench.p_WCell({1, 1}) - workbench.p_WCell({1, 2})).norm(), 0.1, 1e-12);
  EXPECT_GT(workbench.p_WCell({1, 2}).y(), workbench.p_WCell({1, 1}).y());
}

}  // namespace
}  // namespace conceptplan
