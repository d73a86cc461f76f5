#pragma once

#include <atomic>
#include <cstdint>

#include "conceptplan/domain/input_error.hpp"
#include "console.hpp"

namespace conceptplan::cli {

/// The options that every command has.
struct CommonOptions {
  bool json = false;
  bool quiet = false;
  std::uint64_t seed = 0;
  int jobs = 1;  ///< threads
};

/// One run of one command.
struct Session {
  CommonOptions options;
  Console& console;
  const std::atomic<bool>& cancel;  ///< turns true on SIGINT and SIGTERM
};

/// Thrown by a command that ends early because of a signal, after it kept what was finished.
struct Interrupted {};

/// Faults as JSON: [{"path", "line", "column", "key", "message"}]; null where absent.
Json toJson(const std::vector<Fault>& faults);

}  // namespace conceptplan::cli
