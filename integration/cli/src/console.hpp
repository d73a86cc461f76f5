#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace conceptplan::cli {

using Json = nlohmann::ordered_json;

/// Rows of text under headings; columns line up when printed.
using TextTable = std::vector<std::vector<std::string>>;

class Console;
class ProgressMeter;

/// Shows how far some work is, with the time left: a bar on a terminal, else a line every ten
/// seconds; nothing in the first second. A callable value; copies show the same work.
class Progress {
 public:
  explicit Progress(std::shared_ptr<ProgressMeter> meter) : meter_(std::move(meter)) {}

  /// @param note is shown at the end of the line, e.g. the latest loss
  /// @param share of the work's time that is done, where not all of it takes equally long
  void operator()(std::size_t done, std::size_t total, std::string_view note = {},
                  std::optional<double> share = std::nullopt) const;

 private:
  std::shared_ptr<ProgressMeter> meter_;
};

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

  /// The console must outlive it.
  Progress progress(std::string label);

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
