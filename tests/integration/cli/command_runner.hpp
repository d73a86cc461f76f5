#pragma once

#include <functional>
#include <string>
#include <vector>

namespace conceptplan::cli {

/// What a run of the command left.
struct CommandResult {
  int exit_code = -1;  ///< 128 + N if signal N ended it
  std::string out;
  std::string error;
};

/// Runs the built command and waits for it.
CommandResult runCommand(const std::vector<std::string>& arguments);

/// The same, but sends SIGINT once the condition holds, or after a minute.
CommandResult runInterrupted(const std::vector<std::string>& arguments,
                             const std::function<bool()>& condition);

/// The same with SIGKILL, to which no program can answer.
CommandResult runKilled(const std::vector<std::string>& arguments,
                        const std::function<bool()>& condition);

}  // namespace conceptplan::cli
