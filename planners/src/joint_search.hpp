#pragma once

#include <vector>

#include "conceptplan/planners/search_guard.hpp"
#include "joint_space.hpp"

namespace conceptplan {

/// Steps from the start to the goal of a joint space.
struct JointPath {
  std::vector<JointSuccessor> steps;
  PathCost cost = 0;
};

struct JointSearchOptions {
  std::size_t top = 1;      ///< paths wanted
  std::size_t horizon = 0;  ///< longest path, at most kMostSteps
  bool guided = true;       ///< by the space's bound; else not at all
  bool greedy = false;      ///< go by the bound alone
};

/// The best paths, by cost, then by length, unless greedy. Paths in which each target has the same
/// actions are one path, found in its best order. None means that there are none, unless the guard
/// has been stopped.
///
/// A* over states that are numbered as they are met. A state is expanded again for a path to it of
/// other actions, or with fewer steps, until `top` paths no longer than it have been expanded
/// there: whatever goes on from it goes on from each of them.
/// @param expanded becomes the states that were expanded, each once, in the order of the search
std::vector<JointPath> bestJointPaths(JointSpace& space, const JointSearchOptions& options,
                                      SearchGuard& guard, SearchStatistics& statistics,
                                      std::vector<JointState>& expanded);

}  // namespace conceptplan
