#pragma once

namespace conceptplan {

/// @throws std::invalid_argument naming the option if the value is not in [least, most].
void checkOptionRange(const char* option, double value, double least, double most);

}  // namespace conceptplan
