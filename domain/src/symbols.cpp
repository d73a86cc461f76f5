#include "conceptplan/domain/symbols.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace conceptplan {

Symbols mostProbable(const SymbolBelief& belief) {
  Symbols symbols{};
  for (const Concept which : kConcepts) {
    const std::vector<double>& probabilities = belief[index(which)];
    if (probabilities.empty())
      throw std::invalid_argument("the belief of " + std::string(name(which)) + " has no symbols");
    const auto best = std::max_element(probabilities.begin(), probabilities.end());
    symbols[index(which)] = static_cast<SymbolId>(best - probabilities.begin());
  }
  return symbols;
}

SymbolBelief certain(const Symbols& symbols,
                     const std::array<std::size_t, kNumConcepts>& cardinality) {
  SymbolBelief belief;
  for (const Concept which : kConcepts) {
    const std::size_t i = index(which);
    if (symbols[i] < SymbolId{0} || index(symbols[i]) >= cardinality[i])
      throw std::invalid_argument("symbol " + std::to_string(static_cast<int>(symbols[i])) +
                                  " of " + std::string(name(which)) + " is not in [0, " +
                                  std::to_string(cardinality[i]) + ")");
    belief[i].assign(cardinality[i], 0.0);
    belief[i][index(symbols[i])] = 1.0;
  }
  return belief;
}

}  // namespace conceptplan
