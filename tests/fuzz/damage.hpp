#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace conceptplan::testing {

/// Calls `check(bytes, what)` with damaged copies of a file: cut at about `cuts` lengths evenly,
/// from none of it on, and `changes` times with one to four random damages: a bit flipped, a byte
/// set to an extreme, a run removed, repeated, overwritten or moved. The same copies for the same
/// seed.
template <typename Check>
void forEachDamage(const std::string& bytes, std::size_t cuts, std::size_t changes,
                   std::uint64_t seed, const Check& check) {
  const std::size_t stride = std::max<std::size_t>(1, bytes.size() / cuts);
  for (std::size_t length = 0; length < bytes.size(); length += stride)
    check(bytes.substr(0, length), "cut to " + std::to_string(length) + " bytes");
  std::mt19937_64 generator(seed);
  for (std::size_t change = 0; change < changes; ++change) {
    std::string damaged = bytes;
    for (std::uint64_t damages = 1 + generator() % 4; damages > 0 && !damaged.empty(); --damages) {
      const std::size_t at = generator() % damaged.size();
      const std::size_t run = 1 + generator() % std::min<std::size_t>(64, damaged.size() - at);
      switch (generator() % 6) {
        case 0:
          damaged[at] = static_cast<char>(damaged[at] ^ (1 << generator() % 8));
          break;
        case 1:
          damaged[at] = "\xff\x80\x7f\x01"[generator() % 4];
          break;
        case 2:
          damaged.erase(at, run);
          break;
        case 3:
          damaged.insert(at, damaged.substr(at, run));
          break;
        case 4:
          for (std::size_t i = at; i < at + run; ++i) damaged[i] = static_cast<char>(generator());
          break;
        default:
          std::rotate(damaged.begin(), damaged.begin() + static_cast<std::ptrdiff_t>(at),
                      damaged.end());
      }
    }
    if (damaged != bytes) check(damaged, "change " + std::to_string(change));
  }
}

}  // namespace conceptplan::testing
