#pragma once

#include <span>
#include <string>

#include "conceptplan/planners/plan_result.hpp"

namespace conceptplan {

/// The reason of a result with names in place of the indices of the objects that block the way.
/// @param names of all objects of the problem
std::string namedReason(const PlanResult& result, std::span<const std::string> names);

}  // namespace conceptplan
