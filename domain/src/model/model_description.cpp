#include <algorithm>
#include <numeric>
#include <optional>

#include "conceptplan/domain/model/symbolic_model.hpp"

namespace conceptplan {
namespace {

/// Below this share a context reads as "never"; the threshold of the planners' standard options.
constexpr double kNever = 0.01;

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : separator) + part;
  return text;
}

std::string valueName(const ContextFeature& feature, const SymbolicModel& model,
                      std::size_t value) {
  if (isAbsent(feature, model.cardinality(), value)) return "absent";
  if (feature.kind != ContextKind::kNearestOffset) {
    return model.grounding.name(feature.which, static_cast<SymbolId>(value));
  }
  constexpr std::size_t kEdge = 2 * kOffsetReach + 1;
  const int dx = static_cast<int>(value % kEdge) - kOffsetReach;
  const int dy = static_cast<int>(value / kEdge) - kOffsetReach;
  return "(" + std::to_string(dx) + ", " + std::to_string(dy) + ")";
}

std::string need(const LegalityFactor& factor, const SymbolicModel& model) {
  std::vector<std::string> never;
  std::vector<std::string> used;
  for (std::size_t value = 0; value < factor.share.size(); ++value) {
    if (isAbsent(factor.context, model.cardinality(), value)) continue;
    (factor.share[value] <= kNever ? never : used)
        .push_back(valueName(factor.context, model, value));
  }
  if (never.empty()) return "";
  const std::string what = describe(factor.context, model.grounding);
  if (never.size() <= used.size()) return what + " is not " + joined(never, " or ");
  return what + " is " + joined(used, " or ");
}

std::string needs(Action action, const SymbolicModel& model) {
  std::vector<std::string> parts;
  for (const Concept which : kConcepts) {
    for (const ContextFeature& feature : model.transitions.effect(action, which).context) {
      if (feature.kind == ContextKind::kOwnSymbol) continue;
      std::string part =
          "a " + model.grounding.name(Concept::kType, feature.type) + " on the workbench";
      if (std::find(parts.begin(), parts.end(), part) == parts.end()) {
        parts.push_back(std::move(part));
      }
    }
  }
  for (const LegalityFactor& factor : model.legality.factors(action)) {
    std::string part = need(factor, model);
    if (!part.empty()) parts.push_back(std::move(part));
  }
  return parts.empty() ? "nothing" : joined(parts, "; ");
}

std::size_t likeliest(const std::vector<double>& row) {
  return static_cast<std::size_t>(std::max_element(row.begin(), row.end()) - row.begin());
}

/// Whether every row gives the symbol that the single feature of its context has.
bool copies(const Effect& effect) {
  return std::all_of(effect.rows.begin(), effect.rows.end(), [](const auto& entry) {
    return entry.first < entry.second.size() ? likeliest(entry.second) == entry.first : true;
  });
}

/// What the effect does; nothing if the symbol stays.
std::optional<std::string> deed(const Effect& effect, Concept which, const SymbolicModel& model) {
  const std::string concept_name(name(which));
  if (effect.context.size() == 1 && effect.context.front().which == which) {
    const ContextFeature& feature = effect.context.front();
    if (copies(effect)) {
      if (feature.kind == ContextKind::kOwnSymbol) return std::nullopt;
      return concept_name + " becomes that of the nearest " +
             model.grounding.name(Concept::kType, feature.type);
    }
    std::vector<std::string> steps;
    for (const auto& [value, row] : effect.rows) {
      if (feature.kind == ContextKind::kOwnSymbol && likeliest(row) == value) continue;
      steps.push_back(valueName(feature, model, value) + " -> " +
                      model.grounding.name(which, static_cast<SymbolId>(likeliest(row))));
    }
    return concept_name + ": " + joined(steps, ", ");
  }
  if (effect.rows.empty()) return std::nullopt;
  std::vector<std::string> features;
  for (const ContextFeature& feature : effect.context) {
    features.push_back(describe(feature, model.grounding));
  }
  return concept_name + " changes" + (features.empty() ? "" : " with " + joined(features, " and "));
}

double meanLikeliest(const Effect& effect, const ContextCounts& counts) {
  double weight = 0;
  double sum = 0;
  for (const auto& [value, row] : effect.rows) {
    const auto seen = counts.rows.find(value);
    const double steps = seen == counts.rows.end()
                             ? 1
                             : std::accumulate(seen->second.begin(), seen->second.end(), 0.0);
    weight += steps;
    sum += steps * row[likeliest(row)];
  }
  return weight > 0 ? sum / weight : 1;
}

}  // namespace

std::vector<ActionDescription> describe(const SymbolicModel& model) {
  std::vector<ActionDescription> descriptions;
  for (const Action action : kActions) {
    ActionDescription description{action, needs(action, model), "", 1};
    std::vector<std::string> deeds;
    for (const Concept which : kConcepts) {
      const Effect& effect = model.transitions.effect(action, which);
      std::optional<std::string> text = deed(effect, which, model);
      if (!text) continue;
      deeds.push_back(std::move(*text));
      description.probability *=
          meanLikeliest(effect, model.evidence.transitions[index(action)][index(which)]);
    }
    description.does = deeds.empty() ? "nothing" : joined(deeds, "; ");
    descriptions.push_back(std::move(description));
  }
  return descriptions;
}

}  // namespace conceptplan
