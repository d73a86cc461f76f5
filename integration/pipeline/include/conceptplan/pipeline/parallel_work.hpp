#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace conceptplan {

/// Does one piece of work, by its number.
using Worker = std::function<void(std::size_t)>;

/// Hands the numbers [0, count) in order to `jobs` threads, each with a worker of its own. Once
/// `cancel`, if given, turns true, or a worker throws, no more numbers are handed out; what is
/// under way is finished. The first exception is thrown again here.
void workInParallel(std::size_t count, int jobs, const std::atomic<bool>* cancel,
                    const std::function<Worker()>& make_worker);

}  // namespace conceptplan
