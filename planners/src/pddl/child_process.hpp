#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace conceptplan {

/// A folder that only this user can enter, removed with all that is in it.
class PrivateFolder {
 public:
  /// @throws std::runtime_error if it cannot be made.
  PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  ~PrivateFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A program with its arguments; no shell reads them.
struct ChildCommand {
  std::filesystem::path program;  ///< absolute
  std::vector<std::string> arguments;
  std::filesystem::path folder;  ///< working folder, absolute
  std::filesystem::path log;     ///< file for stdout and stderr, absolute
};

/// How a program ended.
struct ChildExit {
  std::optional<int> code;  ///< nothing if a signal ended it
  bool timed_out = false;   ///< killed at the time limit
  bool cancelled = false;   ///< killed since `cancel` turned true
};

/// Runs the program in a process group of its own and waits. At the time limit, and soon after
/// `cancel` turns true, the whole group is killed.
/// @param cancel may be null
/// @throws std::runtime_error if the program cannot be started.
ChildExit runChild(const ChildCommand& command, double timeout_s, const std::atomic<bool>* cancel);

}  // namespace conceptplan
