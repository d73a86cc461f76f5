#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <utility>

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

constexpr int kOffsetsPerAxis = 2 * kOffsetReach + 1;

struct Offset {
  int dx = 0;  ///< columns
  int dy = 0;  ///< rows

  bool operator==(const Offset&) const = default;
};

/// One column or one row away, and what that is in words.
constexpr std::array<std::pair<Offset, const char*>, 4> kNeighbours{
    {{{0, -1}, "a row nearer"},
     {{-1, 0}, "a column to the left"},
     {{1, 0}, "a column to the right"},
     {{0, 1}, "a row farther"}}};

Offset offsetOf(std::size_t value) {
  const int number = static_cast<int>(value);
  return {number % kOffsetsPerAxis - kOffsetReach, number / kOffsetsPerAxis - kOffsetReach};
}

/// Cells along an axis; offsets are clipped, so that the outermost stand for those beyond, too.
std::string cellsName(int cells) {
  const std::string beyond = cells == kOffsetReach ? " or more" : " or less";
  return std::to_string(cells) + (std::abs(cells) == kOffsetReach ? beyond : "");
}

std::string valueName(const ContextFeature& feature, const SymbolicModel& model,
                      std::size_t value) {
  if (feature.kind != ContextKind::kNearestOffset)
    return model.grounding.name(feature.which, static_cast<SymbolId>(value));
  const Offset offset = offsetOf(value);
  return "(" + cellsName(offset.dx) + ", " + cellsName(offset.dy) + ")";
}

std::string valueNames(const ContextFeature& feature, const SymbolicModel& model,
                       const std::vector<std::size_t>& values) {
  std::vector<std::string> names;
  for (const std::size_t value : values) names.push_back(valueName(feature, model, value));
  return joined(names, " or ");
}

/// Neighbouring offsets in words; empty if others are among them.
std::string neighbourNames(const ContextFeature& feature, const std::vector<std::size_t>& values) {
  if (feature.kind != ContextKind::kNearestOffset) return "";
  std::vector<std::string> names;
  for (const auto& [offset, words] : kNeighbours)
    for (const std::size_t value : values)
      if (offsetOf(value) == offset) names.emplace_back(words);
  if (names.size() != values.size()) return "";
  return names.size() == kNeighbours.size() ? "beside" : joined(names, " or ");
}

/// That the feature has, or has not, one of the values.
std::string condition(const ContextFeature& feature, const SymbolicModel& model,
                      const std::vector<std::size_t>& values, bool has) {
  const std::string neighbours = neighbourNames(feature, values);
  if (neighbours.empty())
    return describe(feature, model.grounding) + (has ? " is " : " is not ") +
           valueNames(feature, model, values);
  const std::string object = "the nearest " + model.grounding.name(Concept::kType, feature.type);
  if (neighbours == "beside") return (has ? "only beside " : "not beside ") + object;
  return object + (has ? " is " : " is not ") + neighbours;
}

/// What one factor tells of when an action is taken. @param counts of its values; none if unknown
std::string need(const LegalityFactor& factor, const ContextCounts* counts,
                 const SymbolicModel& model) {
  std::vector<std::size_t> never, used, untried;
  for (std::size_t value = 0; value < factor.share.size(); ++value) {
    if (isAbsent(factor.context, model.cardinality(), value)) continue;
    const bool tried = counts == nullptr || counts->rows.contains(value);
    (factor.share[value] <= kNever ? never : tried ? used : untried).push_back(value);
  }
  if (never.empty()) return "";
  if (used.empty() || never.size() <= used.size())
    return condition(factor.context, model, never, false);
  return condition(factor.context, model, used, true) +
         (untried.empty() ? "" : " (untried: " + valueNames(factor.context, model, untried) + ")");
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
  const std::vector<LegalityFactor>& factors = model.legality.factors(action);
  const std::vector<ContextCounts>& counts = model.evidence.legality[index(action)];
  for (std::size_t i = 0; i < factors.size(); ++i) {
    std::string part = need(factors[i], i < counts.size() ? &counts[i] : nullptr, model);
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
  if (effect.rows.empty()) return std::nullopt;
  const std::string concept_name(name(which));
  if (effect.context.size() == 1 && effect.context.front().which == which &&
      effect.context.front().kind != ContextKind::kNearestOffset) {
    const ContextFeature& feature = effect.context.front();
    const bool own = feature.kind == ContextKind::kOwnSymbol;
    if (copies(effect)) {
      if (own) return std::nullopt;
      std::vector<std::size_t> seen;
      for (const auto& [value, row] : effect.rows) seen.push_back(value);
      return concept_name + " becomes that of the nearest " +
             model.grounding.name(Concept::kType, feature.type) +
             (seen.size() < model.cardinality()[index(which)]
                  ? " (seen: " + valueNames(feature, model, seen) + ")"
                  : "");
    }
    std::vector<std::string> steps;
    for (const auto& [value, row] : effect.rows) {
      if (own && likeliest(row) == value) continue;
      steps.push_back(valueName(feature, model, value) + " -> " +
                      model.grounding.name(which, static_cast<SymbolId>(likeliest(row))));
    }
    return concept_name + (own ? "" : " by " + describe(feature, model.grounding)) + ": " +
           joined(steps, ", ");
  }
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
