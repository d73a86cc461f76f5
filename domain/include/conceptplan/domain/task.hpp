#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/world.hpp"

namespace conceptplan {

enum class Split { kTrain, kValidation, kTest };
enum class ObjectSet { kSeen, kUnseen };
/// `kUnseenTask`: training tasks use other combinations of action types than test tasks do.
enum class Combination { kAll, kUnseenTask };
/// `kShifted`: another camera pose, lens noise, other lights and textures.
enum class RenderDomain { kStandard, kShifted };

/// As on the command line and in files: "train", "validation", "test"; "seen", "unseen"; "all",
/// "unseen-task"; "standard", "shifted".
std::string_view name(Split split);
std::string_view name(ObjectSet objects);
std::string_view name(Combination combination);
std::string_view name(RenderDomain domain);

/// The value of that name; nothing if there is none.
std::optional<Split> splitNamed(std::string_view name);
std::optional<ObjectSet> objectSetNamed(std::string_view name);
std::optional<Combination> combinationNamed(std::string_view name);
std::optional<RenderDomain> renderDomainNamed(std::string_view name);

/// One more object that a task moves, and what it must become.
struct FurtherTarget {
  std::size_t object = 0;  ///< index into the world's objects
  ObjectState goal;
  bool operator==(const FurtherTarget&) const = default;
};

/// One causal planning task. Source: Sec. II-B of arXiv 2310.03325.
struct Task {
  std::string id;                ///< unique in its dataset, e.g. "level3-000017"
  int level = 1;                 ///< 1 movement, 2 + obstacles, 3 + dyer, 4 + rotation
  World initial;                 ///< objects[target] is the target
  ObjectState goal;              ///< what the target must become
  ActionSequence reference;      ///< a shortest plan
  std::uint64_t appearance = 0;  ///< seed of textures, light and colour samples
  /// Targets beside `initial.target`; empty but in tasks of several targets.
  std::vector<FurtherTarget> further = {};
  /// The object that each action of `reference` moves; empty: all move `initial.target`.
  std::vector<std::size_t> moved = {};
};

/// All targets with their goals, `initial.target` first.
std::vector<FurtherTarget> targetsOf(const Task& task);

}  // namespace conceptplan
