#include "ompl_console.hpp"

#include <ompl/util/Console.h>

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace conceptplan {
namespace {

using ompl::msg::OutputHandler;

thread_local int silences = 0;

/// Passes on to the handler that it replaces what threads without a silence say.
class SilencedOutput final : public OutputHandler {
 public:
  explicit SilencedOutput(OutputHandler* replaced) : replaced_(replaced) {}

  OutputHandler* replaced() const { return replaced_; }

  void log(const std::string& text, ompl::msg::LogLevel level, const char* file,
           int line) override {
    if (silences == 0 && replaced_ != nullptr) replaced_->log(text, level, file, line);
  }

 private:
  OutputHandler* replaced_;
};

/// Puts a handler in the place of the current one, and leaves the previous one as it is. OMPL does
/// not offer that: the previous one must be the current one for a moment, in which nothing is
/// written.
void exchange(OutputHandler* handler) {
  const ompl::msg::LogLevel level = ompl::msg::getLogLevel();
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::msg::restorePreviousOutputHandler();
  ompl::msg::useOutputHandler(handler);
  ompl::msg::setLogLevel(level);
}

/// The silences of all threads, and the handler that they share.
class SharedSilence {
 public:
  void begin() {
    const std::lock_guard lock(mutex_);
    if (alive_++ > 0) return;
    output_ = std::make_unique<SilencedOutput>(ompl::msg::getOutputHandler());
    exchange(output_.get());
  }

  void end() {
    const std::lock_guard lock(mutex_);
    if (--alive_ > 0) return;
    if (ompl::msg::getOutputHandler() == output_.get()) {
      exchange(output_->replaced());
    } else {
      left_.push_back(std::move(output_));  // OMPL may have it as the previous one
    }
  }

 private:
  std::mutex mutex_;
  std::size_t alive_ = 0;
  std::unique_ptr<SilencedOutput> output_;
  std::vector<std::unique_ptr<SilencedOutput>> left_;
};

SharedSilence& sharedSilence() {
  static auto* const shared = new SharedSilence;  // OMPL may use what was left until the very end
  return *shared;
}

}  // namespace

OmplSilence::OmplSilence() {
  sharedSilence().begin();
  ++silences;
}

OmplSilence::~OmplSilence() {
  --silences;
  sharedSilence().end();
}

}  // namespace conceptplan
