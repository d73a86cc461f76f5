#include "conceptplan/learner/effect_context.hpp"

#include <stdexcept>
#include <string>

namespace conceptplan {

Tokens effectContext(const SymbolicModel& model, Action action, const Symbols& target,
                     std::span<const Symbols> others, std::span<const Tokens> other_tokens) {
  if (others.size() != other_tokens.size())
    throw std::invalid_argument("effectContext: symbols of " + std::to_string(others.size()) +
                                " objects, tokens of " + std::to_string(other_tokens.size()));
  const Surroundings surroundings{model.grounding, target, others};
  Tokens context = Tokens::Zero();
  for (const Concept which : kConcepts)
    for (const ContextFeature& feature : model.transitions.effect(action, which).context) {
      if (feature.kind != ContextKind::kNearestSymbol || feature.which != which) continue;
      const auto row = static_cast<Eigen::Index>(index(which));
      if (const auto object = nearestObject(feature.type, surroundings))
        context.row(row) = other_tokens[*object].row(row);
    }
  return context;
}

}  // namespace conceptplan
