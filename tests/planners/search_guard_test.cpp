#include "conceptplan/planners/search_guard.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

TEST(SearchGuard, CountsUpToTheLimitOfExpansions) {
  SearchLimits limits;
  limits.max_expansions = 2;
  SearchGuard guard(limits);
  SearchStatistics statistics;
  EXPECT_TRUE(guard.expand(statistics));
  EXPECT_TRUE(guard.expand(statistics));
  EXPECT_FALSE(guard.stopped());
  EXPECT_EQ(guard.reason(), "");
  EXPECT_FALSE(guard.expand(statistics));
  EXPECT_EQ(guard.stopped(), PlanStatus::kLimit);
  EXPECT_EQ(guard.reason(), "stopped at the limit of 2 expansions");
  EXPECT_EQ(statistics.expanded, 2u);
}

TEST(SearchGuard, StopsWhenTimeIsUp) {
  SearchLimits limits;
  limits.timeout_s = 1e-9;
  SearchGuard guard(limits);
  SearchStatistics statistics;
  EXPECT_FALSE(guard.expand(statistics));
  EXPECT_EQ(guard.stopped(), PlanStatus::kTimeout);
}

TEST(SearchGuard, StopsWhenItIsCancelled) {
  std::atomic<bool> cancel{false};
  SearchLimits limits;
  limits.cancel = &cancel;
  SearchGuard guard(limits);
  SearchStatistics statistics;
  EXPECT_TRUE(guard.expand(statistics));
  cancel = true;
  EXPECT_FALSE(guard.expand(statistics));
  EXPECT_EQ(guard.reason(), "cancelled");
  cancel = false;
  EXPECT_FALSE(guard.expand(statistics));
}

TEST(SearchGuard, OtherWorkEndsByTimeAndCancelButIsNotCounted) {
  std::atomic<bool> cancel{false};
  SearchLimits limits;
  limits.max_expansions = 1;
  limits.cancel = &cancel;
  SearchGuard guard(limits);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(guard.goesOn());
  cancel = true;
  EXPECT_FALSE(guard.goesOn());
  EXPECT_EQ(guard.reason(), "cancelled");
  cancel = false;
  EXPECT_FALSE(guard.goesOn());

  limits.timeout_s = 1e-9;
  SearchGuard late(limits);
  EXPECT_FALSE(late.goesOn());
  EXPECT_EQ(late.stopped(), PlanStatus::kTimeout);
}

TEST(SearchGuard, MayKeepSomeOfTheExpansions) {
  SearchLimits limits;
  limits.max_expansions = 10;
  SearchGuard guard(limits);
  SearchStatistics statistics;
  std::size_t made = 0;
  while (guard.leaves(4, statistics) && guard.expand(statistics)) ++made;
  EXPECT_EQ(made, 7u);
  EXPECT_EQ(guard.stopped(), PlanStatus::kLimit);
  EXPECT_EQ(guard.reason(), "stopped at the limit of 10 expansions");
  EXPECT_FALSE(guard.leaves(1, statistics));
}

TEST(SearchGuard, HasTimeAfterItWasStoppedUntilTheTimeIsUpOrItIsCancelled) {
  std::atomic<bool> cancel{false};
  SearchLimits limits;
  limits.cancel = &cancel;
  SearchGuard guard(limits);
  EXPECT_TRUE(guard.hasTime());
  guard.stop(PlanStatus::kLimit, "no idea left");
  EXPECT_TRUE(guard.hasTime());
  cancel = true;
  EXPECT_FALSE(guard.hasTime());
  limits = {};
  limits.timeout_s = 1e-9;
  EXPECT_FALSE(SearchGuard(limits).hasTime());
}

TEST(SearchGuard, APlannerMayStopItself) {
  SearchGuard guard(SearchLimits{});
  SearchStatistics statistics;
  guard.stop(PlanStatus::kLimit, "no idea left");
  EXPECT_FALSE(guard.expand(statistics));
  EXPECT_EQ(guard.stopped(), PlanStatus::kLimit);
  EXPECT_EQ(guard.reason(), "no idea left");
}

}  // namespace
}  // namespace conceptplan
