#pragma once

#include <string>
#include <vector>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/task.hpp"

namespace conceptplan {

/// A task as one line of JSON, without the line's end.
std::string taskRecord(const Task& task);

/// The task of a line; what is wrong with it is added to the faults: what a field says, a workbench
/// that is not the standard one, two objects in a cell, a reference that is illegal or misses the
/// goal.
/// @param origin path and line of the faults
Task parseTaskRecord(const std::string& line, const Fault& origin, std::vector<Fault>& faults);

}  // namespace conceptplan
