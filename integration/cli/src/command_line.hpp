#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "session.hpp"

namespace conceptplan::cli {

/// What a command does once its options are read; returns an `ExitCode`.
using CommandAction = std::function<int(Session&)>;

/// All commands with their options.
class CommandLine {
 public:
  CommandLine();

  /// A command that only holds others, such as `generate`.
  CLI::App& addGroup(const std::string& name, const std::string& summary);

  /// A command, with the common options and an example at the end of its help.
  CLI::App& add(CLI::App& parent, const std::string& name, const std::string& summary,
                const std::string& example, CommandAction action);
  CLI::App& add(const std::string& name, const std::string& summary, const std::string& example,
                CommandAction action) {
    return add(app_, name, summary, example, std::move(action));
  }

  /// Reads the arguments, runs the command and turns whatever happens into an exit code, with a
  /// message on stderr (and with `--json` as {"error": ...} on stdout).
  int run(int argc, const char* const* argv, const std::atomic<bool>& cancel);

 private:
  int perform(Session& session) const;
  /// What is wrong with the arguments, with a hint.
  std::string explain(const CLI::ParseError& error) const;

  CLI::App app_;
  CommonOptions options_;
  CommandAction chosen_;
  std::vector<std::string> arguments_;
};

/// The library's object for a command's options: kept by its action.
template <typename Options>
std::shared_ptr<Options> makeOptions() {
  return std::make_shared<Options>();
}

}  // namespace conceptplan::cli
