#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command_line.hpp"
#include "conceptplan/domain/files/nearest_name.hpp"

namespace conceptplan::cli {

/// An option whose value is one of some names, e.g. `--split train|validation|test`.
/// @param named gives the value of a name, nothing for an unknown one
template <typename Value, typename Named>
CLI::Option* addChoice(CLI::App& command, const std::string& option, Value& value,
                       std::vector<std::string_view> names, Named named,
                       const std::string& summary) {
  std::string type;
  for (const std::string_view name : names) type += (type.empty() ? "" : "|") + std::string(name);
  const auto read = [&value, names, named, option, type](const std::string& text) {
    const std::optional<Value> found = named(text);
    if (!found) {
      throw CLI::ValidationError(
          option, "expected " + type + ", found \"" + text + "\"" + didYouMean(text, names));
    }
    value = *found;
  };
  return command.add_option_function<std::string>(option, read, summary)->type_name(type);
}

}  // namespace conceptplan::cli
