#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/scenario/scenario.hpp"

namespace conceptplan {

/// A YAML file under strict reading: faults are collected, each with its place.
struct YamlDocument {
  std::filesystem::path path;
  YAML::Node root;
  std::vector<Fault> faults;
  std::map<std::string, TextPosition> positions;  ///< of every key read

  void addFault(const YAML::Node& where, const std::string& key, const std::string& message);
};

/// Parses a file. @throws InputError if it cannot be read or is malformed, with the line.
YamlDocument loadYaml(const std::filesystem::path& path);

/// "a map", "a list", "the text \"abc\"" or "nothing".
std::string describe(const YAML::Node& node);

/// One map of a document, read key by key. A getter returns nothing if the key is absent or has a
/// fault, which it adds to the document.
class YamlMap {
 public:
  /// Adds a fault for each unknown or repeated key, or if the node is no map.
  /// @param prefix full name of the map's own key; empty for the root
  /// @param known the keys; empty if any is welcome
  YamlMap(YamlDocument& document, const YAML::Node& node, std::string prefix,
          std::initializer_list<std::string_view> known);

  bool valid() const { return node_.IsMap(); }
  bool has(const std::string& key) const { return values_.contains(key); }
  const std::map<std::string, YAML::Node>& values() const { return values_; }
  /// The full name of a key: "planner.top".
  std::string fullKey(const std::string& key) const;

  /// Adds a fault for a key; at its value if it is there, else at the map.
  void addFault(const std::string& key, const std::string& message);
  /// Adds a fault if the key is absent. @returns whether it is there
  bool require(const std::string& key);

  std::optional<YAML::Node> node(const std::string& key) const;
  std::optional<std::string> text(const std::string& key);
  std::optional<bool> boolean(const std::string& key);
  std::optional<long long> integer(const std::string& key, long long least, long long most);
  std::optional<double> number(const std::string& key, double least, double most);

 private:
  std::optional<YAML::Node> scalar(const std::string& key, const std::string& expected);

  YamlDocument& document_;
  YAML::Node node_;
  std::string prefix_;
  std::map<std::string, YAML::Node> values_;
};

/// A whole number or nothing; quoted text is not a number.
std::optional<long long> integerOf(const YAML::Node& node);
/// A finite number or nothing; quoted text is not a number.
std::optional<double> numberOf(const YAML::Node& node);

}  // namespace conceptplan
