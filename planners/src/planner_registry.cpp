#include "conceptplan/planners/planner_registry.hpp"

#include <stdexcept>

#include "conceptplan/domain/files/nearest_name.hpp"
#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {

void PlannerRegistry::add(PlannerEntry entry) {
  checkIsFree(entry.name);
  entries_.push_back(std::move(entry));
}

void PlannerRegistry::addMissing(std::string name, std::string reason) {
  checkIsFree(name);
  missing_.emplace(std::move(name), std::move(reason));
}

void PlannerRegistry::checkIsFree(const std::string& name) const {
  if (find(name) != nullptr || missing_.contains(name)) {
    throw std::invalid_argument("there is a planner \"" + name + "\" already");
  }
}

const PlannerEntry* PlannerRegistry::find(std::string_view name) const& {
  for (const PlannerEntry& entry : entries_) {
    if (entry.name == name) return &entry;
  }
  return nullptr;
}

const PlannerEntry& PlannerRegistry::entryNamed(const std::string& name,
                                                const std::string& path) const {
  const PlannerEntry* entry = find(name);
  if (entry == nullptr) {
    const auto missing = missing_.find(name);
    std::vector<std::string_view> known;
    for (const PlannerEntry& other : entries_) known.push_back(other.name);
    throw InputError(
        {{path,
          {},
          {},
          "planner.name",
          missing == missing_.end() ? "unknown planner \"" + name + "\"" + didYouMean(name, known)
                                    : "planner \"" + name + "\" " + missing->second}});
  }
  return *entry;
}

std::unique_ptr<Planner> PlannerRegistry::make(const std::string& name, const OptionTexts& options,
                                               const std::string& path) const {
  const PlannerEntry& entry = entryNamed(name, path);
  return entry.make(OptionValues(entry.options, options, path));
}

JointPlanner PlannerRegistry::makeJoint(const std::string& name, const OptionTexts& options,
                                        const std::string& path) const {
  const PlannerEntry& entry = entryNamed(name, path);
  if (!entry.make_joint) {
    std::string others;
    for (const PlannerEntry& other : entries_) {
      if (other.make_joint) others += (others.empty() ? "" : ", ") + other.name;
    }
    throw InputError({{path,
                       {},
                       {},
                       "planner.name",
                       "\"" + name + "\" plans for one target; for several there are " + others}});
  }
  return entry.make_joint(OptionValues(entry.options, options, path));
}

}  // namespace conceptplan
