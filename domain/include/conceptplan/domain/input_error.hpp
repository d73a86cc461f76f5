#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace conceptplan {

/// One thing that is wrong with one input.
struct Fault {
  std::string path;         ///< file, or the option of the command
  std::optional<int> line;  ///< from 1
  std::optional<int> column;
  std::string key;      ///< e.g. "initial.rgb"; empty if none applies
  std::string message;  ///< what was expected and what was found

  /// "path:line:column: key: message", without what is absent.
  std::string text() const;
};

/// A wrong input, with all of its faults collected. The command exits with 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Fault> faults);
  const std::vector<Fault>& faults() const { return faults_; }

 private:
  std::vector<Fault> faults_;
};

}  // namespace conceptplan
