#include "minimal_table.hpp"

#include <algorithm>

namespace conceptplan {
namespace {

/// Whether states that agree in the concepts have one value.
bool determine(const std::vector<Concept>& concepts, const std::vector<Symbols>& states,
               const std::vector<std::int64_t>& values, const ConceptCardinality& cardinality) {
  std::size_t cells = 1;
  for (const Concept which : concepts) cells *= cardinality[index(which)];
  std::vector<std::optional<std::int64_t>> seen(cells);
  for (std::size_t i = 0; i < states.size(); ++i) {
    std::size_t cell = 0;
    for (const Concept which : concepts) {
      cell = cell * cardinality[index(which)] + index(states[i][index(which)]);
    }
    if (!seen[cell]) seen[cell] = values[i];
    if (*seen[cell] != values[i]) return false;
  }
  return true;
}

}  // namespace

std::vector<SymbolId> pick(const Symbols& symbols, const std::vector<Concept>& concepts) {
  std::vector<SymbolId> picked;
  for (const Concept which : concepts) picked.push_back(symbols[index(which)]);
  return picked;
}

MinimalTable minimalTable(const std::vector<Symbols>& states,
                          const std::vector<std::int64_t>& values,
                          const std::vector<Concept>& candidates,
                          const ConceptCardinality& cardinality, std::optional<Concept> kept) {
  MinimalTable table{candidates, {}};
  for (const Concept which : candidates) {
    if (which == kept) continue;
    std::vector<Concept> fewer = table.concepts;
    fewer.erase(std::find(fewer.begin(), fewer.end(), which));
    if (determine(fewer, states, values, cardinality)) table.concepts = std::move(fewer);
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    table.rows.emplace(pick(states[i], table.concepts), values[i]);
  }
  return table;
}

}  // namespace conceptplan
