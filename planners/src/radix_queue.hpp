#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace conceptplan {

/// Which of equal keys is taken first.
enum class TieOrder { kOldestFirst, kNewestFirst };

/// A queue by rising key, for searches in which no key is less than the last one taken: a push
/// costs O(1), and each value is moved at most once a bit of a key. Source: R. K. Ahuja, K.
/// Mehlhorn, J. B. Orlin and R. E. Tarjan, Faster algorithms for the shortest path problem, 1990,
/// doi:10.1145/77600.77615 (one-level radix heap).
template <typename Value>
class RadixQueue {
 public:
  explicit RadixQueue(TieOrder ties) : ties_(ties) {}

  bool empty() const { return size_ == 0; }

  /// @pre the key is not less than the last one taken.
  void push(std::uint64_t key, const Value& value) {
    assert(key >= last_);
    add({key, value});
    ++size_;
  }

  struct Entry {
    std::uint64_t key;
    Value value;
  };

  /// Takes an entry of least key. @pre not empty
  Entry pop() {
    if (taken_ == buckets_[0].size()) refill();
    --size_;
    if (ties_ == TieOrder::kOldestFirst) return buckets_[0][taken_++];
    const Entry newest = buckets_[0].back();
    buckets_[0].pop_back();
    return newest;
  }

 private:
  /// Bucket 0 has the keys that equal the last one taken; bucket b those whose highest bit that
  /// differs from it is bit b - 1. So every key in it is less than those of later buckets.
  void add(const Entry& entry) {
    const auto bucket = static_cast<std::size_t>(std::bit_width(entry.key ^ last_));
    buckets_[bucket].push_back(entry);
  }

  /// Moves the least keys to bucket 0, which has been taken whole. Kept out of the loop that asks
  /// for it.
  [[gnu::noinline]] void refill() {
    buckets_[0].clear();
    taken_ = 0;
    const auto least = std::find_if(buckets_.begin(), buckets_.end(),
                                    [](const auto& bucket) { return !bucket.empty(); });
    last_ = std::min_element(least->begin(), least->end(), [](const Entry& a, const Entry& b) {
              return a.key < b.key;
            })->key;
    for (const Entry& entry : *least) add(entry);
    least->clear();
  }

  TieOrder ties_;
  std::array<std::vector<Entry>, 65> buckets_;  // each in the order in which its entries came
  std::uint64_t last_ = 0;
  std::size_t taken_ = 0;  // of bucket 0, from its front
  std::size_t size_ = 0;
};

}  // namespace conceptplan
