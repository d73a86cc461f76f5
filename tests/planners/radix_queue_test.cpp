#include "radix_queue.hpp"

#include <gtest/gtest.h>

#include <iterator>
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
  EXPECT_EQ(queue.pop().value, 2);
  queue.push(3, 5);  // as small as the last one taken
  EXPECT_EQ(queue.pop().value, 4);
  EXPECT_EQ(queue.pop().value, 5);
  EXPECT_EQ(queue.pop().value, 1);
  EXPECT_EQ(queue.pop().value, 3);
  EXPECT_TRUE(queue.empty());
}

TEST(RadixQueue, TakesValuesByRisingKeyAndTheNewestOfEqualKeys) {
  RadixQueue<int> queue(TieOrder::kNewestFirst);
  queue.push(7, 1);
  queue.push(3, 2);
  queue.push(7, 3);
  queue.push(3, 4);
  EXPECT_EQ(queue.pop().value, 4);
  queue.push(3, 5);  // as small as the last one taken
  EXPECT_EQ(queue.pop().value, 5);
  EXPECT_EQ(queue.pop().value, 2);
  EXPECT_EQ(queue.pop().value, 3);
  EXPECT_EQ(queue.pop().value, 1);
  EXPECT_TRUE(queue.empty());
}

// The heap of Ahuja et al. 1990 against a sorted map.
void expectTheOrderOfASortedQueue(TieOrder ties) {
  std::mt19937_64 random(1);
  RadixQueue<int> queue(ties);
  std::multimap<std::uint64_t, int> sorted;  // equal keys stay in the order of insertion
  std::uint64_t last = 0;
  const auto expectNext = [&] {
    last = sorted.begin()->first;
    const auto next =
        ties == TieOrder::kOldestFirst ? sorted.begin() : std::prev(sorted.upper_bound(last));
    ASSERT_EQ(queue.pop().value, next->second);
    sorted.erase(next);
  };
  std::uint64_t key = 0;
  for (int value = 0; value < 20'000 && last < std::uint64_t{1} << 60; ++value) {
    // Keys near the last one and far from it, so that all buckets are used, and equal ones.
    if (key < last || random() % 4 != 0) key = last + (random() >> (4 + random() % 60));
    queue.push(key, value);
    sorted.emplace(key, value);
    while (!sorted.empty() && random() % 2 == 0) ASSERT_NO_FATAL_FAILURE(expectNext());
  }
  while (!sorted.empty()) ASSERT_NO_FATAL_FAILURE(expectNext());
  EXPECT_TRUE(queue.empty());
}

TEST(RadixQueue, AgreesWithASortedQueueOnDrawnMonotoneWork) {
  expectTheOrderOfASortedQueue(TieOrder::kOldestFirst);
  expectTheOrderOfASortedQueue(TieOrder::kNewestFirst);
}

}  // namespace
}  // namespace conceptplan
