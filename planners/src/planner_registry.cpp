#include "conceptplan/planners/planner_registry.hpp"

#include <stdexcept>

#include "conceptplan/domain/files/nearest_name.hpp"
#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {

void PlannerRegistry::add(PlannerEntry entry) {
  if (find(entry.name) != nullptr) {
    throw std::invalid_argument("there is a planner \"" + entry.name + "\" already");
  }
  entries_.push_back(std::move(entry));
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
    std::vector<std::string_view> known;
    for (const PlannerEntry& other : entries_) known.push_back(other.name);
    throw InputError({{path,
                       {},
                       {},
                       "planner.name",
                       "unknown planner \"" + name + "\"" + didYouMean(name, known)}});
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
