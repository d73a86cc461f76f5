#include "conceptplan/domain/task.hpp"

#include <array>
#include <cstddef>

namespace conceptplan {
namespace {

constexpr std::array<std::string_view, 3> kSplits{"train", "validation", "test"};
constexpr std::array<std::string_view, 2> kObjectSets{"seen", "unseen"};
constexpr std::array<std::string_view, 2> kCombinations{"all", "unseen-task"};
constexpr std::array<std::string_view, 2> kRenderDomains{"standard", "shifted"};

template <typename Value, std::size_t kCount>
std::optional<Value> named(const std::array<std::string_view, kCount>& names,
                           std::string_view name) {
  for (std::size_t i = 0; i < kCount; ++i)
    if (names[i] == name) return static_cast<Value>(i);
  return std::nullopt;
}

}  // namespace

std::string_view name(Split split) { return kSplits.at(static_cast<std::size_t>(split)); }

std::string_view name(ObjectSet objects) {
  return kObjectSets.at(static_cast<std::size_t>(objects));
}

std::string_view name(Combination combination) {
  return kCombinations.at(static_cast<std::size_t>(combination));
}

std::string_view name(RenderDomain domain) {
  return kRenderDomains.at(static_cast<std::size_t>(domain));
}

std::optional<Split> splitNamed(std::string_view name) { return named<Split>(kSplits, name); }

std::optional<ObjectSet> objectSetNamed(std::string_view name) {
  return named<ObjectSet>(kObjectSets, name);
}

std::optional<Combination> combinationNamed(std::string_view name) {
  return named<Combination>(kCombinations, name);
}

std::optional<RenderDomain> renderDomainNamed(std::string_view name) {
  return named<RenderDomain>(kRenderDomains, name);
}

std::vector<FurtherTarget> targetsOf(const Task& task) {
  std::vector<FurtherTarget> targets{{task.initial.target, task.goal}};
  targets.insert(targets.end(), task.further.begin(), task.further.end());
  return targets;
}

}  // namespace conceptplan
