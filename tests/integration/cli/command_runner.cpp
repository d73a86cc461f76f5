#include "integration/cli/command_runner.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

namespace conceptplan::cli {
namespace {

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A run whose streams go to files.
class Process {
 public:
  explicit Process(const std::vector<std::string>& arguments) {
    static int runs = 0;
    const std::string stem = testing::TempDir() + "conceptplan-" + std::to_string(::getpid()) +
                             "-" + std::to_string(runs++);
    out_ = stem + ".out";
    error_ = stem + ".error";
    std::vector<char*> words{const_cast<char*>(CONCEPTPLAN_COMMAND)};
    for (const std::string& argument : arguments)
      words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    constexpr int kFlags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_.c_str(), kFlags, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, error_.c_str(), kFlags, 0600);
    if (posix_spawn(&id_, CONCEPTPLAN_COMMAND, &actions, nullptr, words.data(), environ) != 0) {
      ADD_FAILURE() << "cannot run " << CONCEPTPLAN_COMMAND;
    }
    posix_spawn_file_actions_destroy(&actions);
  }

  bool running() {
    if (!ended_ && ::waitpid(id_, &status_, WNOHANG) == id_) ended_ = true;
    return !ended_;
  }

  void send(int signal) { ::kill(id_, signal); }

  CommandResult wait() {
    if (!ended_) ::waitpid(id_, &status_, 0);
    ended_ = true;
    CommandResult result;
    result.exit_code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
    result.out = contents(out_);
    result.error = contents(error_);
    std::filesystem::remove(out_);
    std::filesystem::remove(error_);
    return result;
  }

 private:
  std::string out_;
  std::string error_;
  pid_t id_ = 0;
  int status_ = 0;
  bool ended_ = false;
};

CommandResult runUntil(const std::vector<std::string>& arguments,
                       const std::function<bool()>& condition, int signal) {
  Process process(arguments);
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (process.running() && !condition() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  if (process.running()) process.send(signal);
  return process.wait();
}

}  // namespace

CommandResult runCommand(const std::vector<std::string>& arguments) {
  return Process(arguments).wait();
}

CommandResult runInterrupted(const std::vector<std::string>& arguments,
                             const std::function<bool()>& condition) {
  return runUntil(arguments, condition, SIGINT);
}

CommandResult runKilled(const std::vector<std::string>& arguments,
                        const std::function<bool()>& condition) {
  return runUntil(arguments, condition, SIGKILL);
}

}  // namespace conceptplan::cli
