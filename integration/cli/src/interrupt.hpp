#pragma once

#include <atomic>

namespace conceptplan::cli {

/// Makes SIGINT and SIGTERM set the flag in place of ending the program, so that what is finished
/// is kept. A second signal ends it at once. Call it once, before threads start.
/// @returns the flag
const std::atomic<bool>& catchInterrupts();

}  // namespace conceptplan::cli
