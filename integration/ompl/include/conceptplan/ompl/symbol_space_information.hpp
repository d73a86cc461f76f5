#pragma once

#include <ompl/base/ProblemDefinition.h>
#include <ompl/control/SpaceInformation.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "conceptplan/ompl/symbol_state_space.hpp"

namespace conceptplan {

struct SymbolSpaceOptions {
  double legality_threshold = 0.01;  ///< an action is legal where Pr[a | Omega] is greater
  unsigned int control_samples =
      1;  ///< actions tried to come near a state, >= 1; the best is taken
  /// Of all samplers; without it they draw from OMPL's generator of the process.
  std::optional<std::uint64_t> seed;
  /// Asked for each motion between two valid states, and its answers are not kept; null: every
  /// motion passes. What it needs must outlive the space. Such as `FclValidity::checkMotion`:
  /// docs/ompl.md.
  MotionCheck check_motion = nullptr;
};

/// A symbol graph with all that OMPL's control planners ask for, set up:
/// - a SymbolStateSpace and an ActionSpace; one action lasts for the duration 1;
/// - a propagator by the most probable outcome of each action, `SymbolStateSpace::kNowhere` where
///   it is not legal or its motion is denied;
/// - validity of a state as compiled into the graph, by whatever StateValidity; the problem's start
///   counts as valid, since the target stands there;
/// - a motion validator: two valid states are joined where one action leads from the first to the
///   second, and `check_motion` passes the motion between them.
/// Checkers may be called from several threads.
/// @throws std::invalid_argument if the graph is null or an option is out of range.
ompl::control::SpaceInformationPtr makeSpaceInformation(std::shared_ptr<const SymbolGraph> graph,
                                                        const SymbolSpaceOptions& options = {});

/// Sets the most probable start and goal of the graph.
/// @pre the definition's space information is by `makeSpaceInformation`
void setStartAndGoal(ompl::base::ProblemDefinition& problem);

}  // namespace conceptplan
