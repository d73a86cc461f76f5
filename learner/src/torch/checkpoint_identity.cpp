#include "conceptplan/learner/torch/checkpoint_identity.hpp"

#include <ATen/Parallel.h>

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

constexpr const char* kKey = "identity";
constexpr const char* kThreads = "threads";
constexpr const char* kNone = "none";
constexpr const char* kRemedy = "; remove it to begin anew";

/// What the archive says of its run; nothing if it says nothing, or nothing of sense.
std::optional<std::map<std::string, std::string>> stored(torch::serialize::InputArchive& archive) {
  c10::IValue text;
  if (!archive.try_read(kKey, text) || !text.isString()) return std::nullopt;
  const auto json = nlohmann::json::parse(text.toStringRef(), nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return std::nullopt;
  std::map<std::string, std::string> values;
  for (const auto& [name, value] : json.items()) {
    if (!value.is_string()) return std::nullopt;
    values[name] = value.get<std::string>();
  }
  return values;
}

/// The value of that name, or "none".
std::string valueOf(const std::map<std::string, std::string>& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() || found->second.empty() ? kNone : found->second;
}

/// What helps if the checkpoint has `there` under that name, and this run something else.
std::string remedyOf(const std::string& name, const std::string& there) {
  return name == kThreads && there != kNone ? "; go on with --jobs " + there : kRemedy;
}

}  // namespace

CheckpointIdentity::CheckpointIdentity() { add(kThreads, std::int64_t{at::get_num_threads()}); }

void CheckpointIdentity::add(const std::string& name, const std::string& value) {
  values_[name] = value;
}

void CheckpointIdentity::add(const std::string& name, std::int64_t value) {
  values_[name] = std::to_string(value);
}

void CheckpointIdentity::add(const std::string& name, std::uint64_t value) {
  values_[name] = std::to_string(value);
}

void CheckpointIdentity::add(const std::string& name, double value) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  values_[name] = std::string(text.data(), end);
}

void CheckpointIdentity::write(torch::serialize::OutputArchive& archive) const {
  archive.write(kKey, c10::IValue(nlohmann::json(values_).dump()));
}

void CheckpointIdentity::check(torch::serialize::InputArchive& archive,
                               const std::filesystem::path& path) const {
  const auto found = stored(archive);
  if (!found)
    throw InputError({{path.string(),
                       {},
                       {},
                       kKey,
                       std::string("the checkpoint does not say of which seed, options and data it "
                                   "is, as those of older versions") +
                           kRemedy}});
  std::map<std::string, std::string> all = values_;
  all.insert(found->begin(), found->end());
  std::vector<Fault> faults;
  for (const auto& [name, value] : all) {
    const std::string here = valueOf(values_, name), there = valueOf(*found, name);
    if (here != there)
      faults.push_back(
          {path.string(),
           {},
           {},
           name,
           "this run has " + here + ", the checkpoint is of " + there + remedyOf(name, there)});
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace conceptplan
