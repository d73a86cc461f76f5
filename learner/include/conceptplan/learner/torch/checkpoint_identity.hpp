#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace conceptplan {

/// Which run a checkpoint is of: all that its steps depend on, by name, e.g. seed, each option and
/// a checksum of the data. Torch's number of threads is always part of it, as "threads": sums are
/// rounded differently with another one.
class CheckpointIdentity {
 public:
  CheckpointIdentity();

  void add(const std::string& name, const std::string& value);
  void add(const std::string& name, std::int64_t value);
  void add(const std::string& name, std::uint64_t value);
  void add(const std::string& name, double value);

  void write(torch::serialize::OutputArchive& archive) const;

  /// @param path stands in the faults. @throws InputError that names all that differs, or says that
  /// the checkpoint is of a version that stored none.
  void check(torch::serialize::InputArchive& archive, const std::filesystem::path& path) const;

 private:
  std::map<std::string, std::string> values_;
};

}  // namespace conceptplan
