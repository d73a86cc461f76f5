#include "blocking_objects.hpp"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

namespace conceptplan {
namespace {

/// States looked at, in all.
constexpr std::size_t kMostVisits = 2'000'000;

/// The subsets of a set by rising size, then by number.
std::vector<ObstacleSet> subsetsBySize(ObstacleSet set) {
  std::vector<ObstacleSet> subsets;
  for (ObstacleSet subset = set; subset != 0; subset = (subset - 1) & set)
    subsets.push_back(subset);
  std::sort(subsets.begin(), subsets.end(), [](ObstacleSet a, ObstacleSet b) {
    return std::pair(std::popcount(a), a) < std::pair(std::popcount(b), b);
  });
  return subsets;
}

}  // namespace

ObstacleSet collidedObject(const Verdict& verdict) {
  const bool counts = verdict.cause == Invalidity::kCollision && verdict.object < kMostObjects;
  return counts ? ObstacleSet{1} << verdict.object : 0;
}

ObstacleSet fewestBlocking(ObstacleSet all, std::size_t num_states,
                           const std::function<bool(ObstacleSet)>& leads_without,
                           SearchGuard& guard) {
  if (all == 0 || !leads_without(all)) return 0;
  std::size_t visits = num_states;
  for (const ObstacleSet subset : subsetsBySize(all)) {
    visits += num_states;
    if (visits > kMostVisits || !guard.goesOn()) return 0;
    if (leads_without(subset)) return subset;
  }
  return 0;
}

}  // namespace conceptplan
