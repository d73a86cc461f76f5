#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {

/// Reads the fields of a JSON object and collects what is wrong with them. A field that is wrong
/// reads as a default.
class JsonFields {
 public:
  /// @param origin path and line of every fault
  /// @param prefix put before every key, e.g. "goal."
  JsonFields(const nlohmann::json& object, Fault origin, std::vector<Fault>& faults,
             std::string prefix = "")
      : object_(object), origin_(std::move(origin)), faults_(faults), prefix_(std::move(prefix)) {
    if (!object_.is_object()) fault("", "expected an object");
  }

  /// The field; null, and a fault, if it is missing.
  const nlohmann::json& at(const std::string& key) {
    static const nlohmann::json kMissing;
    known_.insert(key);
    if (!object_.is_object()) return kMissing;
    const auto field = object_.find(key);
    if (field != object_.end()) return *field;
    fault(key, "is missing");
    return kMissing;
  }

  std::uint64_t unsignedInteger(const std::string& key, std::uint64_t low = 0,
                                std::uint64_t high = std::numeric_limits<std::uint64_t>::max()) {
    const nlohmann::json& field = at(key);
    if (field.is_null()) return low;
    if (field.is_number_unsigned()) {
      const auto value = field.get<std::uint64_t>();
      if (value >= low && value <= high) return value;
    }
    fault(key, "expected an integer in [" + std::to_string(low) + ", " + std::to_string(high) +
                   "], found " + field.dump());
    return low;
  }

  /// @pre 0 <= low <= high
  int integer(const std::string& key, int low, int high) {
    return static_cast<int>(
        unsignedInteger(key, static_cast<std::uint64_t>(low), static_cast<std::uint64_t>(high)));
  }

  std::string text(const std::string& key) {
    const nlohmann::json& field = at(key);
    if (field.is_string()) return field.get<std::string>();
    if (!field.is_null()) fault(key, "expected a text, found " + field.dump());
    return "";
  }

  bool boolean(const std::string& key) {
    const nlohmann::json& field = at(key);
    if (field.is_boolean()) return field.get<bool>();
    if (!field.is_null()) fault(key, "expected true or false, found " + field.dump());
    return false;
  }

  /// An enumerator by its name. @param named the function that knows the names
  template <typename Value>
  Value choice(const std::string& key, std::optional<Value> (*named)(std::string_view)) {
    const nlohmann::json& field = at(key);
    if (field.is_string())
      if (const std::optional<Value> value = named(field.get<std::string>())) return *value;
    if (!field.is_null()) fault(key, "has no value " + field.dump());
    return Value{};
  }

  /// A fault for every key that was not asked for.
  void rejectOthers() {
    if (!object_.is_object()) return;
    for (const auto& [key, value] : object_.items())
      if (!known_.contains(key)) fault(key, "is unknown");
  }

  void fault(const std::string& key, std::string message) {
    Fault fault = origin_;
    fault.key = prefix_ + key;
    fault.message = std::move(message);
    faults_.push_back(std::move(fault));
  }

 private:
  const nlohmann::json& object_;
  Fault origin_;
  std::vector<Fault>& faults_;
  std::string prefix_;
  std::set<std::string> known_;
};

}  // namespace conceptplan
