#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "conceptplan/planners/joint_planner.hpp"
#include "conceptplan/planners/planner.hpp"
#include "conceptplan/planners/planner_option.hpp"

namespace conceptplan {

/// All that is said of a planner, and how to make one.
struct PlannerEntry {
  std::string name;
  std::string summary;                       ///< one line
  std::string source = {};                   ///< citation
  std::vector<std::string> guarantees = {};  ///< what holds of its answers
  std::vector<PlannerOption> options = {};
  std::function<std::unique_ptr<Planner>(const OptionValues&)> make;
  /// The same search for several targets; empty if there is none.
  std::function<JointPlanner(const OptionValues&)> make_joint = {};
};

/// The planners by name. A value: programs may add planners of their own to a copy.
class PlannerRegistry {
 public:
  /// All planners of this library.
  static PlannerRegistry standard();

  /// @throws std::invalid_argument if the name is taken.
  void add(PlannerEntry entry);

  /// Notes a planner that is known but cannot be had here, and why: "needs ...". `make` says so.
  /// @throws std::invalid_argument if the name is taken.
  void addMissing(std::string name, std::string reason);

  /// In order of addition. Of a named registry alone, since the entries live in it.
  const std::vector<PlannerEntry>& entries() const& { return entries_; }
  const std::vector<PlannerEntry>& entries() const&& = delete;
  /// Null if there is none.
  const PlannerEntry* find(std::string_view name) const&;
  const PlannerEntry* find(std::string_view name) const&& = delete;

  /// @param path stands in the faults.
  /// @throws InputError for an unknown or missing planner (key "planner.name") or wrong options,
  /// all at once; names the nearest known name.
  std::unique_ptr<Planner> make(const std::string& name, const OptionTexts& options = {},
                                const std::string& path = "") const;

  /// The planner of several targets.
  /// @throws InputError as `make`, and for a planner of one target, naming those of several.
  JointPlanner makeJoint(const std::string& name, const OptionTexts& options = {},
                         const std::string& path = "") const;

 private:
  const PlannerEntry& entryNamed(const std::string& name, const std::string& path) const;
  void checkIsFree(const std::string& name) const;

  std::vector<PlannerEntry> entries_;
  std::map<std::string, std::string> missing_;  // name -> reason
};

/// `docs/planners.md`.
std::string toMarkdown(const PlannerRegistry& registry);

/// A JSON array with name, summary, source, guarantees and options of each planner.
std::string toJson(const PlannerRegistry& registry);

}  // namespace conceptplan
