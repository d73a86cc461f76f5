#include "conceptplan/pipeline/object_name.hpp"

namespace conceptplan {

std::string objectName(const SymbolGrounding& grounding, const SymbolBelief& belief, int instance) {
  const std::vector<std::string>& types = grounding.names[index(Concept::kType)];
  const std::size_t type = index(mostProbable(belief)[index(Concept::kType)]);
  const bool named = type < types.size() && !types[type].empty();
  return (named ? types[type] : "object") + " " + std::to_string(instance);
}

}  // namespace conceptplan
