#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace conceptplan::cli {

using Json = nlohmann::ordered_json;

/// Rows of text under headings; columns line up when printed.
using TextTable = std::vector<std::vector<std::string>>;

/// The two streams of the command: answers on stdout, all else on stderr. Thread-safe.
class Console {
 public:
  /// @param json stdout carries one JSON document and nothing else
  /// @param quiet no progress and no messages; errors and answers remain
  Console(bool json, bool quiet) : json_(json), quiet_(quiet) {}

  bool json() const { return json_; }

  /// Prints for a person; nothing with `--json`.
  void print(std::string_view text);
  /// The first row is the heading.
  void print(const TextTable& table);
  /// Prints the document with `--json`, nothing without.
  void printJson(const Json& document);
  /// A line on stderr unless quiet.
  void message(std::string_view text);
  /// A line on stderr, always.
  void error(std::string_view text);

  /// A callback (done, total) that shows progress with the time left: a bar on a terminal, else a
  /// line every ten seconds; nothing for the first second. The console must outlive it.
  std::function<void(std::size_t, std::size_t)> progress(std::string label);

 private:
  friend class ProgressMeter;
  void writeError(std::string_view text);

  bool json_;
  bool quiet_;
  std::mutex mutex_;
  bool bar_shown_ = false;
};

/// "1 h 05 min", "3 min 20 s" or "12 s".
std::string durationText(double seconds);

/// A number with so many decimals, always with a point.
std::string decimal(double value, int decimals);

}  // namespace conceptplan::cli
