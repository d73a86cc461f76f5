#include "conceptplan/domain/simulation/random_stream.hpp"

#include <limits>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

// The finaliser of SplitMix64. Source: Steele, Lea, Flood, OOPSLA 2014.
std::uint64_t mix(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

}  // namespace

std::uint64_t stableHash(std::initializer_list<std::uint64_t> key) {
  std::uint64_t hash = 0x243f6a8885a308d3u;
  for (const std::uint64_t part : key) hash = mix(hash ^ mix(part));
  return hash;
}

std::size_t RandomStream::below(std::size_t count) {
  if (count == 0) throw std::invalid_argument("cannot draw from 0 values");
  constexpr std::uint64_t kMax = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t bound = kMax - kMax % count;
  std::uint64_t draw = engine_();
  while (draw >= bound) draw = engine_();
  return static_cast<std::size_t>(draw % count);
}

int RandomStream::between(int low, int high) {
  if (low > high)
    throw std::invalid_argument("cannot draw from [" + std::to_string(low) + ", " +
                                std::to_string(high) + "]");
  return low + static_cast<int>(below(static_cast<std::size_t>(high - low) + 1));
}

}  // namespace conceptplan
