#include "result_log.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"

namespace conceptplan::cli {
namespace {

std::string lineOf(const Json& result) {
  return result.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<ResultKey> keyOf(const Json& result) {
  if (!result.is_object()) return std::nullopt;
  const auto scenario = result.find("scenario");
  const auto planner = result.find("planner");
  const auto seed = result.find("seed");
  if (scenario == result.end() || !scenario->is_string() || planner == result.end() ||
      !planner->is_string() || seed == result.end() || !seed->is_number_unsigned()) {
    return std::nullopt;
  }
  return ResultKey{*scenario, *planner, *seed};
}

/// The value of a field; null if it is missing.
Json fieldOf(const Json& object, const char* key) { return object.value(key, Json()); }

bool isText(const Json& value) { return value.is_string(); }

bool isPlan(const Json& plan) {
  if (!plan.is_object()) return false;
  const Json actions = fieldOf(plan, "actions");
  // Only plans for several targets have objects.
  const Json objects = plan.value("objects", actions);
  return actions.is_array() && std::all_of(actions.begin(), actions.end(), isText) &&
         objects.is_array() && objects.size() == actions.size() &&
         fieldOf(plan, "length").is_number() && fieldOf(plan, "probability").is_number();
}

bool arePlans(const Json& plans) {
  return plans.is_array() && std::all_of(plans.begin(), plans.end(), isPlan);
}

bool isEvaluation(const Json& evaluation) {
  if (!evaluation.is_object()) return evaluation.is_null();
  const Json right = fieldOf(evaluation, "top1");
  return right == true || (right == false && isText(fieldOf(evaluation, "failure")));
}

bool areTimes(const Json& times) {
  return times.is_object() && fieldOf(times, "total").is_number();
}

/// A field that is read again, and what `solve` writes there.
struct ResultField {
  const char* key;
  const char* expected;
  bool (*holds)(const Json& value);
};

constexpr std::array kFields{ResultField{"status", "text", isText},
                             ResultField{"plans", "a list of plans", arePlans},
                             ResultField{"evaluation", "an evaluation or null", isEvaluation},
                             ResultField{"times_ms", "times with a total", areTimes}};

/// What makes a line no result, with the key; nothing if it is one.
std::optional<Fault> faultOf(const Json& line) {
  Fault fault{"", {}, {}, "", "expected a result of solve"};
  if (!keyOf(line)) return fault;
  for (const ResultField& field : kFields) {
    const bool has = line.contains(field.key);
    if (has && field.holds(line[field.key])) continue;
    fault.key = field.key;
    fault.message = std::string("expected ") + field.expected + ", found " +
                    (has ? line[field.key].type_name() : "nothing");
    return fault;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Json> readResults(const std::filesystem::path& path) {
  const std::string text = readFile(path);
  std::vector<Json> results;
  std::vector<Fault> faults;
  int number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    ++number;
    const std::size_t end = text.find('\n', begin);
    if (end == std::string::npos) break;  // a torn last line
    Json result = Json::parse(text.substr(begin, end - begin), nullptr, false);
    begin = end + 1;
    if (result.is_discarded() && begin == text.size()) break;
    std::optional<Fault> fault = faultOf(result);
    if (!fault) {
      results.push_back(std::move(result));
      continue;
    }
    fault->path = path.string();
    fault->line = number;
    fault->message += "; remove the line";
    faults.push_back(*std::move(fault));
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return results;
}

ResultLog::ResultLog(std::filesystem::path path, std::vector<ResultKey> keys, bool resume)
    : path_(std::move(path)), keys_(std::move(keys)) {
  if (path_.empty()) return;
  if (path_.has_parent_path()) createFolder(path_.parent_path());
  std::string kept;
  if (resume && std::filesystem::exists(path_)) {
    readExisting();
    for (const Json& result : results()) kept += lineOf(result);
  }
  writeFileAtomically(path_, kept);
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  if (descriptor_ < 0) {
    throw InputError({Fault{path_.string(),
                            {},
                            {},
                            "",
                            "cannot be written: " + std::generic_category().message(errno)}});
  }
}

ResultLog::~ResultLog() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void ResultLog::readExisting() {
  for (const Json& result : readResults(path_)) {
    const ResultKey key = keyOf(result).value();
    if (std::find(keys_.begin(), keys_.end(), key) == keys_.end()) others_.push_back(key);
    results_[key] = result;
  }
}

bool ResultLog::has(const ResultKey& key) const {
  const std::lock_guard lock(mutex_);
  return results_.contains(key);
}

std::size_t ResultLog::numResults() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(
      keys_.begin(), keys_.end(), [this](const ResultKey& key) { return results_.contains(key); }));
}

void ResultLog::add(const Json& result) {
  const std::optional<ResultKey> key = keyOf(result);
  if (!key) throw std::invalid_argument("a result without scenario, planner and seed");
  const std::lock_guard lock(mutex_);
  results_[*key] = result;
  if (descriptor_ < 0) return;
  const std::string line = lineOf(result);
  for (std::size_t written = 0; written < line.size();) {
    const ssize_t count = ::write(descriptor_, line.data() + written, line.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      throw std::runtime_error(path_.string() +
                               ": writing failed: " + std::generic_category().message(errno));
    }
    written += static_cast<std::size_t>(count);
  }
  ::fsync(descriptor_);
}

std::vector<Json> ResultLog::results() const {
  const std::lock_guard lock(mutex_);
  std::vector<Json> ordered;
  for (const std::vector<ResultKey>* keys : {&keys_, &others_}) {
    for (const ResultKey& key : *keys) {
      const auto found = results_.find(key);
      if (found != results_.end()) ordered.push_back(found->second);
    }
  }
  return ordered;
}

void ResultLog::finish() {
  if (path_.empty()) return;
  std::string text;
  for (const Json& result : results()) text += lineOf(result);
  writeFileAtomically(path_, text);
}

}  // namespace conceptplan::cli
