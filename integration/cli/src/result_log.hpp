#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "console.hpp"

namespace conceptplan::cli {

/// What tells one result from another.
struct ResultKey {
  std::string scenario;
  std::string planner;
  std::uint64_t seed = 0;
  auto operator<=>(const ResultKey&) const = default;
};

/// The results that `solve` wrote to a file, without a torn last line.
/// @throws InputError if the file cannot be read, or with every other line that is no result.
std::vector<Json> readResults(const std::filesystem::path& path);

/// The results of one `solve`, on disk as soon as they are there: each is appended as one line of
/// JSON and flushed to the disk. `finish` brings them into the order of the keys, so that the file
/// is the same at any number of jobs. Thread-safe.
class ResultLog {
 public:
  /// @param path the file; empty: results are only kept in memory
  /// @param keys of all results, in their final order, each once
  /// @param resume keep the results that are there already, without a torn last line; otherwise
  ///   begin anew
  /// @throws InputError if the file cannot be written or, on resuming, a line that is not torn is
  /// no
  ///   result.
  ResultLog(std::filesystem::path path, std::vector<ResultKey> keys, bool resume);
  ResultLog(const ResultLog&) = delete;
  ResultLog& operator=(const ResultLog&) = delete;
  ~ResultLog();

  /// Whether the result is there.
  bool has(const ResultKey& key) const;
  std::size_t numResults() const;

  /// Appends a result with the fields `scenario`, `planner` and `seed` of one of the keys.
  /// @throws std::runtime_error if writing fails.
  void add(const Json& result);

  /// All results in the order of the keys; results of other keys that an earlier run left follow.
  std::vector<Json> results() const;

  /// Rewrites the file in that order, atomically.
  void finish();

 private:
  void readExisting();

  std::filesystem::path path_;
  std::vector<ResultKey> keys_;
  std::map<ResultKey, Json> results_;
  std::vector<ResultKey> others_;
  int descriptor_ = -1;
  mutable std::mutex mutex_;
};

}  // namespace conceptplan::cli
