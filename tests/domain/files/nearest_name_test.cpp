#include "conceptplan/domain/files/nearest_name.hpp"

#include <gtest/gtest.h>

#include <array>

namespace conceptplan {
namespace {

constexpr std::array<std::string_view, 4> kNames{"belief", "bfs", "dijkstra", "astar"};

TEST(NearestName, FindsTyposSwapsAndCase) {
  EXPECT_EQ(nearestName("beleif", kNames), "belief");
  EXPECT_EQ(nearestName("BFS", kNames), "bfs");
  EXPECT_EQ(nearestName("dijkstr", kNames), "dijkstra");
  EXPECT_EQ(nearestName("astarr", kNames), "astar");
}

TEST(NearestName, SilentWhenNothingIsNear) {
  EXPECT_EQ(nearestName("transformer", kNames), std::nullopt);
  EXPECT_EQ(nearestName("", kNames), std::nullopt);
  EXPECT_EQ(nearestName("belief", {}), std::nullopt);
}

TEST(NearestName, EndOfAMessage) {
  EXPECT_EQ(didYouMean("bsf", kNames), "; did you mean \"bfs\"?");
  EXPECT_EQ(didYouMean("quite other", kNames), "");
}

}  // namespace
}  // namespace conceptplan
