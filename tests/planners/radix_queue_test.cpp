#include "radix_queue.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace conceptplan {
namespace {

TEST(RadixQueue, TakesValuesByRisingKeyAndTheOldestOfEqualKeys) {
  RadixQueue<int> queue(TieOrder::kOldestFirst);
  queue.push(7, 1);
  queue.push(3, 2);
  queue.push(7, 3);
  queue.push(3, 4);
  EXPECT_EQ(queue.pop(), 2);
  queue.push(3, 5);  // as small as the last one taken
  EXPECT_EQ(queue.pop(), 4);
  EXPECT_EQ(queue.pop(), 5);
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_EQ(queue.pop(), 3);
  EXPECT_TRUE(queue.empty());
}

TEST(RadixQueue, TakesValuesByRisingKeyAndTheNewestOfEqualKeys) {
  RadixQueue<int> queue(TieOrder::kNewestFirst);
  queue.push(7, 1);
  queue.push(3, 2);
  queue.push(7, 3);
  queue.push(3, 4);
  EXPECT_EQ(queue.pop(), 4);
  queue.push(3, 5);  // as small as the last one taken
  EXPECT_EQ(queue.pop(), 5);
  EXPECT_EQ(queue.pop(), 2);
  EXPECT_EQ(queue.pop(), 3);
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_TRUE(queue.empty());
}

// The heap of Ahuja et al. 1990 against a sorted map.
TEST(RadixQueue, AgreesWithASortedQueueOnDrawnMonotoneWork) {
  std::mt19937_64 random(1);
  RadixQueue<int> queue(TieOrder::kOldestFirst);
  std::multimap<std::uint64_t, int> sorted;  // equal keys stay in the order of insertion
  std::uint64_t last = 0;
  for (int value = 0; value < 20'000; ++value) {
    // Keys near the last one and far from it, so that all buckets are used.
    const std::uint64_t key = last + (random() >> (4 + random() % 60));
    queue.push(key, value);
    sorted.emplace(key, value);
    while (!sorted.empty() && random() % 2 == 0) {
      last = sorted.begin()->first;
      ASSERT_EQ(queue.pop(), sorted.begin()->second);
      sorted.erase(sorted.begin());
    }
    if (last > std::uint64_t{1} << 60) break;
  }
  for (const auto& [key, value] : sorted) ASSERT_EQ(queue.pop(), value);
  EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace conceptplan
