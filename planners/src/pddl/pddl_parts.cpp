#include "pddl_parts.hpp"

#include "action_schemas.hpp"
#include "pddl_names.hpp"

namespace conceptplan {
namespace {

/// A person's name as a comment of one line.
std::string commentText(const std::string& symbol, const std::string& given) {
  std::string text = "    ; " + symbol + ": " + given;
  for (char& letter : text) {
    if (static_cast<unsigned char>(letter) < ' ') letter = ' ';
  }
  return text + "\n";
}

}  // namespace

std::vector<Concept> toldConcepts(const SymbolGraph& graph) {
  std::vector<Concept> concepts;
  for (const Concept which : kConcepts) {
    if (graph.mutability(which) != Mutability::kNeverChanges) concepts.push_back(which);
  }
  return concepts;
}

std::string typesText(const std::vector<Concept>& concepts) {
  if (concepts.empty()) return "";
  std::string text = "  (:types";
  for (const Concept which : concepts) text += " " + typeName(which);
  return text + ")\n";
}

std::string symbolsText(const SymbolGraph& graph, const PddlOptions& options) {
  const ConceptCardinality cardinality = cardinalityOf(graph);
  std::string text;
  for (const Concept which : toldConcepts(graph)) {
    const std::vector<std::string>& given = options.symbol_names[index(which)];
    std::string symbols, comments;
    for (std::size_t i = 0; i < cardinality[index(which)]; ++i) {
      const std::string symbol = objectName(which, static_cast<SymbolId>(i));
      symbols += symbol + " ";
      if (i < given.size()) comments += commentText(symbol, given[i]);
    }
    text += "    " + symbols + "- " + typeName(which) + "\n" + comments;
  }
  return text;
}

std::string targetPredicates(const std::vector<Concept>& concepts) {
  std::string text;
  for (const Concept which : concepts) {
    text += "    " + targetAtom(which, variables({which})) + "\n";
  }
  return text;
}

std::string legalName(Action action) { return "legal_" + std::string(name(action)); }

std::string variable(Concept which) { return "?" + typeName(which); }

std::string variables(const std::vector<Concept>& concepts) {
  std::string text;
  for (const Concept which : concepts) {
    text += (text.empty() ? "" : " ") + variable(which) + " - " + typeName(which);
  }
  return text;
}

std::string declaration(const std::string& name, const std::vector<Concept>& concepts) {
  return "(" + name + (concepts.empty() ? "" : " ") + variables(concepts) + ")";
}

std::string atomText(const std::string& name, const std::vector<Concept>& concepts) {
  std::string text = "(" + name;
  for (const Concept which : concepts) text += " " + variable(which);
  return text + ")";
}

std::string factText(const std::string& name, const std::vector<Concept>& concepts,
                     const std::vector<SymbolId>& symbols) {
  std::string text = "(" + name;
  for (std::size_t i = 0; i < concepts.size(); ++i) {
    text += " " + objectName(concepts[i], symbols[i]);
  }
  return text + ")";
}

std::string factsText(const std::string& name, const MinimalTable& table) {
  std::string text;
  for (const auto& [symbols, value] : table.rows) {
    if (value == 1) text += "    " + factText(name, table.concepts, symbols) + "\n";
  }
  return text;
}

std::string targetFacts(const std::vector<Concept>& concepts, const Symbols& symbols) {
  std::string text;
  for (const Concept which : concepts) {
    text += "    " + targetFact(which, symbols[index(which)]) + "\n";
  }
  return text;
}

}  // namespace conceptplan
