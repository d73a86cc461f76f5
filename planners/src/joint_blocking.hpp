#pragma once

#include "joint_search.hpp"

namespace conceptplan {

/// The fewest objects that are no targets without which there is a joint plan of whatever length;
/// `BlockingObjects` tells of which. The problem without them has been solved.
///
/// Ends as unknown where a limit strikes, or once a million states of single targets have been
/// worked out.
/// @pre targets are shut in: `JointSpace::isShutIn`
/// @param search of a plan; neither its number of plans nor its horizon is read
/// @param statistics gets what it takes
BlockingObjects blockingObjects(const SymbolicModel& model, const JointProblem& problem,
                                const StateValidity& validity, const StepRules& rules,
                                const JointSearchOptions& search, SearchGuard& guard,
                                SearchStatistics& statistics);

}  // namespace conceptplan
