#include "ompl_console.hpp"

#include <ompl/util/Console.h>

#include <mutex>
#include <string>

namespace conceptplan {
namespace {

thread_local int silences = 0;

/// Passes on what threads without a silence say.
class SilencedOutput final : public ompl::msg::OutputHandler {
 public:
  explicit SilencedOutput(OutputHandler* next) : next_(next) {}

  void log(const std::string& text, ompl::msg::LogLevel level, const char* file,
           int line) override {
    if (silences == 0 && next_ != nullptr) next_->log(text, level, file, line);
  }

 private:
  OutputHandler* next_;
};

}  // namespace

OmplSilence::OmplSilence() {
  static std::once_flag installed;
  std::call_once(installed, [] {
    static SilencedOutput output(ompl::msg::getOutputHandler());
    ompl::msg::useOutputHandler(&output);
  });
  ++silences;
}

OmplSilence::~OmplSilence() { --silences; }

}  // namespace conceptplan
