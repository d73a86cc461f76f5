#include "blocking_objects.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>

#include "model_tables.hpp"

namespace conceptplan {
namespace {

/// Sets tried, in all.
constexpr std::size_t kMostTrials = 10'000;

/// Of more watched objects not each subset is tried before the search.
constexpr std::size_t kMostWatched = 3;

/// Whether any removal may lead to the goal; nothing as of the trial. What is only met is best
/// removed altogether; of what is watched any part may be.
std::optional<bool> mayLead(const RemovableObjects& all, const RemovalTrial& trial) {
  if (all.watched.size() > kMostWatched) return true;
  for (std::size_t part = 0; part < std::size_t{1} << all.watched.size(); ++part) {
    SceneObjects removed;
    for (std::size_t i = 0; i < all.watched.size(); ++i) {
      if ((part >> i & 1) != 0) removed.push_back(all.watched[i]);
    }
    const std::optional<Removal> without_them = trial(joined(all.met, removed));
    if (!without_them) return std::nullopt;
    if (without_them->way) return true;
  }
  return false;
}

}  // namespace

SceneObjects joined(const SceneObjects& objects, std::span<const std::size_t> more) {
  std::set<std::size_t> all(objects.begin(), objects.end());
  all.insert(more.begin(), more.end());
  return {all.begin(), all.end()};
}

SceneObjects without(const SceneObjects& objects, const SceneObjects& others) {
  SceneObjects rest;
  std::ranges::set_difference(objects, others, std::back_inserter(rest));
  return rest;
}

SceneObjects allBut(const SceneObjects& objects, std::size_t count) {
  SceneObjects all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return without(all, objects);
}

RemovableObjects removableObjects(const SymbolicModel& model, std::span<const SymbolBelief> scene,
                                  const SceneObjects& targets) {
  const std::vector<bool> is_watched = watchedTypes(model);
  RemovableObjects all;
  for (const std::size_t object : allBut(targets, scene.size())) {
    const SymbolId type = mostProbable(scene[object])[index(Concept::kType)];
    (is_watched[index(type)] ? all.watched : all.met).push_back(object);
  }
  return all;
}

BlockingObjects fewestBlocking(const RemovableObjects& all, const RemovalTrial& trial) {
  BlockingObjects unknown{{}, 0, true};
  const std::optional<bool> may_lead = mayLead(all, trial);
  if (!may_lead) return unknown;
  std::set<SceneObjects> sets;
  if (*may_lead) sets.insert(SceneObjects());
  std::size_t trials = 0;
  while (!sets.empty()) {
    std::set<SceneObjects> larger;
    for (const SceneObjects& removed : sets) {
      if (++trials > kMostTrials) return unknown;
      const std::optional<Removal> without_them = trial(removed);
      if (!without_them) return unknown;
      if (without_them->way) return {removed, *without_them->way};
      for (const std::size_t object : without_them->in_the_way) {
        larger.insert(joined(removed, {&object, 1}));
        if (larger.size() > kMostTrials) larger.erase(std::prev(larger.end()));
      }
    }
    sets = std::move(larger);
  }
  return {};
}

std::string remark(const BlockingObjects& blocking, std::size_t horizon, const SearchGuard& guard) {
  if (blocking.is_unknown) {
    return "; which objects block the way is not known: " +
           (guard.stopped() ? guard.reason() : "there are too many to try without");
  }
  if (blocking.way <= horizon) return {};
  return "; a way without what blocks it has " + std::to_string(blocking.way) + " actions";
}

}  // namespace conceptplan
