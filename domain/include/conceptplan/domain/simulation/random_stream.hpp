#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace conceptplan {

/// A 64-bit hash of a key of numbers, the same on every platform and in every version: files and
/// splits depend on it.
std::uint64_t stableHash(std::initializer_list<std::uint64_t> key);

/// Portable draws from a stream of its own: the same key gives the same draws everywhere, and
/// streams of different keys are independent.
class RandomStream {
 public:
  explicit RandomStream(std::initializer_list<std::uint64_t> key) : engine_(stableHash(key)) {}

  /// Uniform in [0, count), without bias. @pre count > 0
  std::size_t below(std::size_t count);

  /// Uniform in [low, high]. @pre low <= high
  int between(int low, int high);

 private:
  std::mt19937_64 engine_;
};

}  // namespace conceptplan
