#include "conceptplan/pipeline/parallel_work.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace conceptplan {

void workInParallel(std::size_t count, int jobs, const std::atomic<bool>* cancel,
                    const std::function<Worker()>& make_worker) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      const Worker worker = make_worker();
      while (!failed && !(cancel != nullptr && *cancel)) {
        const std::size_t number = next++;
        if (number >= count) return;
        worker(number);
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      failed = true;
    }
  };
  std::vector<std::thread> threads;
  const std::size_t wanted = std::min(static_cast<std::size_t>(std::max(jobs, 1)), count);
  for (std::size_t job = 1; job < wanted; ++job) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace conceptplan
