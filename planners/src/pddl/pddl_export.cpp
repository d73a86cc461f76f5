#include "conceptplan/planners/pddl/pddl_export.hpp"

#include <algorithm>

#include "action_schemas.hpp"
#include "pddl_names.hpp"
#include "pddl_parts.hpp"

namespace conceptplan {
namespace {

/// The variable of a symbol after the action.
std::string nextVariable(Concept which) { return variable(which) + "_next"; }

bool contains(const std::vector<Concept>& concepts, Concept which) {
  return std::find(concepts.begin(), concepts.end(), which) != concepts.end();
}

std::string costName(Action action) { return "cost_" + std::string(name(action)); }

std::string leadsName(Action action, Concept which) {
  return "leads_" + std::string(name(action)) + "_" + typeName(which);
}

/// An atom or a fact with one more word at its end.
std::string with(std::string atom, const std::string& last) {
  return atom.insert(atom.size() - 1, " " + last);
}

std::string parametersText(const ActionSchema& schema) {
  std::string text;
  for (const Concept which : schema.parameters) {
    text += (text.empty() ? "" : " ") + variable(which);
    if (contains(schema.changes, which)) text += " " + nextVariable(which);
    text += " - " + typeName(which);
  }
  return text;
}

std::string preconditionText(const ActionSchema& schema, const MinimalTable& valid) {
  std::string text;
  for (const Concept which : schema.parameters) {
    text += "\n      " + targetAtom(which, variable(which));
  }
  if (!schema.legal.isConstant()) {
    text += "\n      " + atomText(legalName(schema.action), schema.legal.concepts);
  }
  for (std::size_t i = 0; i < schema.changes.size(); ++i) {
    const Concept which = schema.changes[i];
    text += "\n      " + with(atomText(leadsName(schema.action, which), schema.leads[i].concepts),
                              nextVariable(which));
  }
  if (schema.may_be_invalid) {
    text += "\n      (valid";
    for (const Concept which : valid.concepts) {
      text += " " + (contains(schema.changes, which) ? nextVariable(which) : variable(which));
    }
    text += ")";
  }
  return text;
}

std::string effectText(const ActionSchema& schema) {
  std::string text;
  for (const Concept which : schema.changes) {
    text += "\n      (not " + targetAtom(which, variable(which)) + ") " +
            targetAtom(which, nextVariable(which));
  }
  const std::string cost = schema.cost.isConstant()
                               ? std::to_string(schema.cost.rows.begin()->second)
                               : atomText(costName(schema.action), schema.cost.concepts);
  return text + "\n      (increase (total-cost) " + cost + ")";
}

bool mentionsValidity(const ActionSchemas& schemas) {
  return std::any_of(schemas.actions.begin(), schemas.actions.end(),
                     [](const ActionSchema& schema) { return schema.may_be_invalid; });
}

std::string domainText(const SymbolGraph& graph, const ActionSchemas& schemas,
                       const std::string& domain) {
  const std::vector<Concept> told = toldConcepts(graph);
  std::string text = "(define (domain " + domain +
                     ")\n  (:requirements :strips :typing :action-costs)\n" + typesText(told) +
                     "  (:predicates\n" + targetPredicates(told);
  std::string functions = "    (total-cost) - number\n";
  if (mentionsValidity(schemas)) {
    text += "    " + declaration("valid", schemas.valid.concepts) + "\n";
  }
  for (const ActionSchema& schema : schemas.actions) {
    if (!schema.legal.isConstant()) {
      text += "    " + declaration(legalName(schema.action), schema.legal.concepts) + "\n";
    }
    for (std::size_t i = 0; i < schema.changes.size(); ++i) {
      const Concept which = schema.changes[i];
      text += "    " +
              with(declaration(leadsName(schema.action, which), schema.leads[i].concepts),
                   nextVariable(which) + " - " + typeName(which)) +
              "\n";
    }
    if (!schema.cost.isConstant()) {
      functions +=
          "    " + declaration(costName(schema.action), schema.cost.concepts) + " - number\n";
    }
  }
  text += "  )\n  (:functions\n" + functions + "  )\n";
  for (const ActionSchema& schema : schemas.actions) {
    text += "  (:action " + std::string(name(schema.action)) + "\n    :parameters (" +
            parametersText(schema) + ")\n    :precondition (and" +
            preconditionText(schema, schemas.valid) + ")\n    :effect (and" + effectText(schema) +
            "))\n";
  }
  return text + ")\n";
}

/// "(leads_move_left_position_x position_x-1 position_x-0)" for each row.
std::string leadsFacts(const ActionSchema& schema, std::size_t change) {
  const Concept which = schema.changes[change];
  const MinimalTable& leads = schema.leads[change];
  std::string text;
  for (const auto& [symbols, next] : leads.rows) {
    text += "    " +
            with(factText(leadsName(schema.action, which), leads.concepts, symbols),
                 objectName(which, static_cast<SymbolId>(next))) +
            "\n";
  }
  return text;
}

std::string costFacts(const ActionSchema& schema) {
  std::string text;
  for (const auto& [symbols, cost] : schema.cost.rows) {
    text += "    (= " + factText(costName(schema.action), schema.cost.concepts, symbols) + " " +
            std::to_string(cost) + ")\n";
  }
  return text;
}

std::string problemText(const SymbolGraph& graph, const ActionSchemas& schemas,
                        const std::string& domain, const PddlOptions& options) {
  const std::vector<Concept> told = toldConcepts(graph);
  std::string text = "(define (problem " + domain + ")\n  (:domain " + domain + ")\n  (:objects\n" +
                     symbolsText(graph, options) + "  )\n  (:init\n    (= (total-cost) 0)\n" +
                     targetFacts(told, mostProbable(graph.initialBelief()));
  if (mentionsValidity(schemas)) text += factsText("valid", schemas.valid);
  for (const ActionSchema& schema : schemas.actions) {
    if (!schema.legal.isConstant()) text += factsText(legalName(schema.action), schema.legal);
    for (std::size_t i = 0; i < schema.changes.size(); ++i) text += leadsFacts(schema, i);
    if (!schema.cost.isConstant()) text += costFacts(schema);
  }
  return text + "  )\n  (:goal (and\n" + targetFacts(told, mostProbable(graph.problem().goal)) +
         "  ))\n  (:metric minimize (total-cost))\n)\n";
}

}  // namespace

PddlText toPddl(const SymbolGraph& graph, const PddlOptions& options) {
  checkDeterminisation(options.determinisation);
  const ActionSchemas schemas(graph, options.determinisation);
  const std::string domain = pddlName(options.name);
  return {domainText(graph, schemas, domain), problemText(graph, schemas, domain, options)};
}

}  // namespace conceptplan
