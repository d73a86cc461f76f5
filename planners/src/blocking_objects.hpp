#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/planners/search_guard.hpp"

namespace conceptplan {

/// Objects of a scene, by rising index.
using SceneObjects = std::vector<std::size_t>;

SceneObjects joined(const SceneObjects& objects, std::span<const std::size_t> more);
/// The objects that are no part of the other set.
SceneObjects without(const SceneObjects& objects, const SceneObjects& others);
/// All of a scene of so many but these.
SceneObjects allBut(const SceneObjects& objects, std::size_t count);

/// The objects that may be taken out of a scene.
struct RemovableObjects {
  SceneObjects met;      ///< can be met; nothing else depends on them
  SceneObjects watched;  ///< on these it may also depend what actions do, or whether they are legal
};
/// @param targets of the scene, which stay
RemovableObjects removableObjects(const SymbolicModel& model, std::span<const SymbolBelief> scene,
                                  const SceneObjects& targets);

/// What becomes of a problem without some objects.
struct Removal {
  std::optional<std::size_t> way;  ///< to the goal, in actions; nothing if there is none
  SceneObjects in_the_way;         ///< without a way: some that any larger removal with one takes
};
/// Nothing where a limit struck, or where it grew too long.
using RemovalTrial = std::function<std::optional<Removal>(const SceneObjects& removed)>;

struct BlockingObjects {
  SceneObjects objects;     ///< empty if objects are not the reason, or not found to be
  std::size_t way = 0;      ///< that there is without them, in actions
  bool is_unknown = false;  ///< since a trial came to no end
};

/// The fewest objects without which there is a way, of these the first by number. Sets are tried by
/// rising size, and one without a way grows by each object that is in the way then, so that none
/// with a way is passed over. Unknown after 10,000 sets.
/// Source: the hitting-set tree of R. Reiter, 1987, doi:10.1016/0004-3702(87)90062-2.
BlockingObjects fewestBlocking(const RemovableObjects& all, const RemovalTrial& trial);

/// What is to be told of them but their names: that they are not known, or that the way without
/// them is beyond the horizon. Begins with "; ", empty if there is nothing to tell.
std::string remark(const BlockingObjects& blocking, std::size_t horizon, const SearchGuard& guard);

}  // namespace conceptplan
