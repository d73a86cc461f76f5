#include "interrupt.hpp"

#include <csignal>

namespace conceptplan::cli {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set in a signal handler");

extern "C" void setInterrupted(int) { interrupted.store(true); }

}  // namespace

const std::atomic<bool>& catchInterrupts() {
  struct sigaction action {};
  action.sa_handler = setInterrupted;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  return interrupted;
}

}  // namespace conceptplan::cli
