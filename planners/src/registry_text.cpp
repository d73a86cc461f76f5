#include <nlohmann/json.hpp>

#include "conceptplan/planners/planner_registry.hpp"

namespace conceptplan {

std::string toMarkdown(const PlannerRegistry& registry) {
  std::string text =
      "# Planners\n\n"
      "Made from the registry of planners and held to it by a test; do not edit by hand.\n";
  for (const PlannerEntry& entry : registry.entries()) {
    text += "\n## " + entry.name + "\n\n" + entry.summary + "\n\nSource: " + entry.source +
            "\n\nGuarantees:\n\n";
    for (const std::string& guarantee : entry.guarantees) text += "- " + guarantee + "\n";
    text += "\n| option | type | default | range | meaning |\n|---|---|---|---|---|\n";
    for (const PlannerOption& option : entry.options) {
      std::string range = option.range();
      for (std::size_t bar = range.find('|'); bar != std::string::npos;
           bar = range.find('|', bar + 2)) {
        range.insert(bar, 1, '\\');
      }
      text += "| `" + option.name + "` | " + option.typeName() + " | " + option.standard + " | " +
              range + " | " + option.summary + " |\n";
    }
  }
  return text;
}

std::string toJson(const PlannerRegistry& registry) {
  using Json = nlohmann::ordered_json;
  Json planners = Json::array();
  for (const PlannerEntry& entry : registry.entries()) {
    Json options = Json::array();
    for (const PlannerOption& option : entry.options) {
      options.push_back({{"name", option.name},
                         {"type", option.typeName()},
                         {"default", option.standard},
                         {"range", option.range()},
                         {"summary", option.summary}});
    }
    planners.push_back({{"name", entry.name},
                        {"summary", entry.summary},
                        {"source", entry.source},
                        {"guarantees", entry.guarantees},
                        {"options", options}});
  }
  return planners.dump(2);
}

}  // namespace conceptplan
