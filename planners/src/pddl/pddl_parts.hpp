#pragma once

#include <string>
#include <vector>

#include "conceptplan/planners/pddl/pddl_export.hpp"
#include "minimal_table.hpp"

namespace conceptplan {

// Pieces of text that PDDL and PPDDL share. Lists of declarations are indented and end their lines.

/// The concepts that a file tells of: those that some action of the model changes. One that nothing
/// changes here is told of too, since start and goal must agree in it.
std::vector<Concept> toldConcepts(const SymbolGraph& graph);

/// "(:types ...)"; nothing without concepts.
std::string typesText(const std::vector<Concept>& concepts);

/// All symbols of all concepts: "color-0 color-1 - color", with the person's names as comments.
std::string symbolsText(const SymbolGraph& graph, const PddlOptions& options);

/// "(target_color ?color - color)" for each concept.
std::string targetPredicates(const std::vector<Concept>& concepts);

/// "legal_move_left".
std::string legalName(Action action);

/// "?color".
std::string variable(Concept which);

/// "?position_x - position_x ?color - color".
std::string variables(const std::vector<Concept>& concepts);

/// "(NAME ?position_x - position_x)": a predicate or function over the concepts of a table.
std::string declaration(const std::string& name, const std::vector<Concept>& concepts);

/// "(NAME ?position_x ?color)".
std::string atomText(const std::string& name, const std::vector<Concept>& concepts);

/// "(NAME position_x-0 color-1)".
std::string factText(const std::string& name, const std::vector<Concept>& concepts,
                     const std::vector<SymbolId>& symbols);

/// A fact for each row whose value is 1.
std::string factsText(const std::string& name, const MinimalTable& table);

/// "(target_color color-0)" for each concept.
std::string targetFacts(const std::vector<Concept>& concepts, const Symbols& symbols);

}  // namespace conceptplan
