#pragma once

#include "command_line.hpp"

namespace conceptplan::cli {

// Each adds one command with its options.

void addPlannersCommand(CommandLine& line);
void addValidateCommand(CommandLine& line);

}  // namespace conceptplan::cli
