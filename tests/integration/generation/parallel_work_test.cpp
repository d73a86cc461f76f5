#include "conceptplan/pipeline/parallel_work.hpp"

#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

namespace conceptplan {
namespace {

TEST(ParallelWork, EveryNumberOnce) {
  for (const int jobs : {1, 3, 50}) {
    std::mutex mutex;
    std::multiset<std::size_t> seen;
    int workers = 0;
    workInParallel(20, jobs, nullptr, [&]() -> Worker {
      const std::lock_guard lock(mutex);
      ++workers;
      return [&](std::size_t number) {
        const std::lock_guard inner(mutex);
        seen.insert(number);
      };
    });
    EXPECT_EQ(seen.size(), 20u);
    EXPECT_EQ(std::set<std::size_t>(seen.begin(), seen.end()).size(), 20u);
    EXPECT_EQ(workers, std::min(jobs, 20));
  }
}

TEST(ParallelWork, NothingToDo) {
  workInParallel(0, 2, nullptr, []() -> Worker { return [](std::size_t) { FAIL(); }; });
}

TEST(ParallelWork, CancelEndsItSoon) {
  std::atomic<bool> cancel{false};
  std::atomic<int> calls{0};
  workInParallel(1000, 2, &cancel, [&]() -> Worker {
    return [&](std::size_t) {
      if (++calls == 5) cancel = true;
      while (calls > 5 && !cancel) std::this_thread::yield();  // until the fifth call has said so
    };
  });
  EXPECT_LE(calls, 7);
}

TEST(ParallelWork, TheFirstExceptionIsThrownAgain) {
  EXPECT_THROW(workInParallel(100, 2, nullptr,
                              []() -> Worker {
                                return [](std::size_t number) {
                                  if (number == 7) throw std::runtime_error("seven");
                                };
                              }),
               std::runtime_error);
}

}  // namespace
}  // namespace conceptplan
