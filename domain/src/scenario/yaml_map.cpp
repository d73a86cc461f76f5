#include "yaml_map.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/nearest_name.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kLargestFile = 1 << 20;  // bytes
constexpr std::size_t kShownLetters = 60;

bool isPlain(const YAML::Node& node) { return node.IsScalar() && node.Tag() != "!"; }

template <typename Value>
std::optional<Value> parse(const YAML::Node& node) {
  if (!isPlain(node)) return std::nullopt;
  const std::string& text = node.Scalar();
  const char* const end = text.data() + text.size();
  Value value{};
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::string rangeText(const std::string& kind, double least, double most) {
  std::ostringstream text;
  text << kind << " in [" << least << ", " << most << "]";
  return text.str();
}

TextPosition positionOf(const YAML::Mark& mark) { return {mark.line + 1, mark.column + 1}; }

}  // namespace

void YamlDocument::addFault(const YAML::Node& where, const std::string& key,
                            const std::string& message) {
  const YAML::Mark mark = where.Mark();
  Fault fault{path.string(), {}, {}, key, message};
  if (!mark.is_null()) {
    fault.line = mark.line + 1;
    fault.column = mark.column + 1;
  }
  faults.push_back(std::move(fault));
}

YamlDocument loadYaml(const std::filesystem::path& path) {
  YamlDocument document{path, {}, {}, {}};
  const std::string text = readFile(path);
  if (text.size() > kLargestFile) {
    throw InputError(
        {Fault{path.string(),
               {},
               {},
               "",
               "expected at most 1 MiB, found " + std::to_string(text.size()) + " bytes"}});
  }
  try {
    document.root = YAML::Load(text);
  } catch (const YAML::Exception& error) {
    Fault fault{path.string(), {}, {}, "", "malformed YAML: " + error.msg};
    if (!error.mark.is_null()) {
      fault.line = error.mark.line + 1;
      fault.column = error.mark.column + 1;
    }
    throw InputError({fault});
  }
  return document;
}

std::string describe(const YAML::Node& node) {
  if (node.IsMap()) return "a map";
  if (node.IsSequence()) return "a list";
  if (!node.IsScalar()) return "nothing";
  std::string text = node.Scalar();
  if (text.size() > kShownLetters) text = text.substr(0, kShownLetters) + "...";
  return "\"" + text + "\"";
}

std::optional<long long> integerOf(const YAML::Node& node) { return parse<long long>(node); }

std::optional<double> numberOf(const YAML::Node& node) {
  const std::optional<double> value = parse<double>(node);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

YamlMap::YamlMap(YamlDocument& document, const YAML::Node& node, std::string prefix,
                 std::initializer_list<std::string_view> known)
    : document_(document), node_(node), prefix_(std::move(prefix)) {
  if (!node.IsMap()) {
    document.addFault(node, prefix_, "expected a map of keys, found " + describe(node));
    return;
  }
  for (const auto& entry : node) {
    if (!entry.first.IsScalar()) {
      document.addFault(entry.first, prefix_,
                        "a key must be a word, found " + describe(entry.first));
      continue;
    }
    const std::string& key = entry.first.Scalar();
    const std::string full = fullKey(key);
    const std::vector<std::string_view> names(known);
    if (!names.empty() && std::find(names.begin(), names.end(), key) == names.end()) {
      document.addFault(entry.first, full, "unknown key" + didYouMean(key, names));
      continue;
    }
    if (!values_.emplace(key, entry.second).second) {
      document.addFault(
          entry.first, full,
          "the key is given twice; first at line " + std::to_string(document.positions[full].line));
      continue;
    }
    document.positions[full] = positionOf(entry.first.Mark());
  }
}

std::string YamlMap::fullKey(const std::string& key) const {
  return prefix_.empty() ? key : prefix_ + "." + key;
}

void YamlMap::addFault(const std::string& key, const std::string& message) {
  const auto found = values_.find(key);
  document_.addFault(found == values_.end() ? node_ : found->second, fullKey(key), message);
}

bool YamlMap::require(const std::string& key) {
  if (!valid()) return false;
  if (!has(key)) addFault(key, "the key is missing");
  return has(key);
}

std::optional<YAML::Node> YamlMap::node(const std::string& key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<YAML::Node> YamlMap::scalar(const std::string& key, const std::string& expected) {
  const std::optional<YAML::Node> value = node(key);
  if (!value || value->IsScalar()) return value;
  addFault(key, "expected " + expected + ", found " + describe(*value));
  return std::nullopt;
}

std::optional<std::string> YamlMap::text(const std::string& key) {
  const std::optional<YAML::Node> value = scalar(key, "text");
  if (!value) return std::nullopt;
  if (value->Scalar().empty()) {
    addFault(key, "expected text, found nothing");
    return std::nullopt;
  }
  return value->Scalar();
}

std::optional<bool> YamlMap::boolean(const std::string& key) {
  const std::optional<YAML::Node> value = scalar(key, "true or false");
  if (!value) return std::nullopt;
  if (isPlain(*value) && value->Scalar() == "true") return true;
  if (isPlain(*value) && value->Scalar() == "false") return false;
  addFault(key, "expected true or false, found " + describe(*value));
  return std::nullopt;
}

std::optional<long long> YamlMap::integer(const std::string& key, long long least, long long most) {
  const std::string expected =
      "a whole number in [" + std::to_string(least) + ", " + std::to_string(most) + "]";
  const std::optional<YAML::Node> value = scalar(key, expected);
  if (!value) return std::nullopt;
  const std::optional<long long> number = integerOf(*value);
  if (number && *number >= least && *number <= most) return number;
  addFault(key, "expected " + expected + ", found " + describe(*value));
  return std::nullopt;
}

std::optional<double> YamlMap::number(const std::string& key, double least, double most) {
  const std::string expected = rangeText("a number", least, most);
  const std::optional<YAML::Node> value = scalar(key, expected);
  if (!value) return std::nullopt;
  const std::optional<double> number = numberOf(*value);
  if (number && *number >= least && *number <= most) return number;
  addFault(key, "expected " + expected + ", found " + describe(*value));
  return std::nullopt;
}

}  // namespace conceptplan
