#pragma once

namespace conceptplan::cli {

/// What the command returns to the shell; docs/command.md lists them.
enum ExitCode : int {
  kDone = 0,
  kNoPlan = 1,  ///< done, and at least one scenario has no plan
  kWrongInput = 2,
  kInternalFailure = 3,
  kInterrupted = 130  ///< what was finished is kept
};

}  // namespace conceptplan::cli
