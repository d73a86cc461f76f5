#pragma once

#include <set>
#include <stdexcept>
#include <string>

#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan::testing {

/// The state of facts such as "target_position_x position_x-2"; other facts do not count.
inline StateId stateOf(const SymbolGraph& graph, const std::set<std::string>& facts) {
  Symbols symbols = graph.symbols(graph.mostProbableStart());
  for (const std::string& fact : facts) {
    for (const Concept which : kConcepts) {
      std::string type(name(which));
      for (char& letter : type) letter = static_cast<char>(std::tolower(letter));
      const std::string begin = "target_" + type + " " + type + "-";
      if (!fact.starts_with(begin)) continue;
      symbols[index(which)] = static_cast<SymbolId>(std::stoi(fact.substr(begin.size())));
    }
  }
  return graph.state(symbols);
}

}  // namespace conceptplan::testing
