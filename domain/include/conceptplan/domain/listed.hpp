#pragma once

#include <string>
#include <vector>

namespace conceptplan {

/// "Cup 1", "Cup 1 and Pot 2", "Cup 1, Pot 2 and Pot 3".
std::string listed(const std::vector<std::string>& words);

}  // namespace conceptplan
