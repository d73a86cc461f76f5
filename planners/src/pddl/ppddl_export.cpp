#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "action_schemas.hpp"
#include "conceptplan/planners/pddl/pddl_export.hpp"
#include "pddl_names.hpp"
#include "pddl_parts.hpp"

namespace conceptplan {
namespace {

constexpr std::int64_t kBillion = 1'000'000'000;

/// The next symbols of one concept by number, with billionths that sum to one.
using Shares = std::vector<std::pair<SymbolId, std::int64_t>>;

Shares sharesOf(const SymbolGraph& graph, StateId state, Action action, Concept which) {
  std::map<SymbolId, double> probability;
  for (const Transition& outcome : graph.transitions(state, action)) {
    probability[graph.symbols(outcome.state)[index(which)]] += outcome.probability;
  }
  Shares shares;
  std::int64_t rest = kBillion;
  for (const auto& [symbol, p] : probability) {
    shares.emplace_back(symbol, std::llround(p * static_cast<double>(kBillion)));
    rest -= shares.back().second;
  }
  std::max_element(shares.begin(), shares.end(), [](const auto& a, const auto& b) {
    return a.second < b.second;
  })->second += rest;
  return shares;
}

/// "0.25"; without zeros at the end.
std::string decimalText(std::int64_t billionths) {
  if (billionths == kBillion) return "1";
  std::string digits = std::to_string(billionths);
  digits.insert(0, 9 - digits.size(), '0');
  return "0." + digits.substr(0, digits.find_last_not_of('0') + 1);
}

/// How an action changes one concept.
class ConceptEffect {
 public:
  ConceptEffect(const SymbolGraph& graph, const PossibleStates& legal, Action action, Concept which)
      : which_(which) {
    std::map<Shares, std::int64_t> number_of;
    std::vector<std::int64_t> numbers;
    for (const StateId state : legal.states) {
      const Shares shares = sharesOf(graph, state, action, which);
      const auto [known, fresh] =
          number_of.emplace(shares, static_cast<std::int64_t>(distinct_.size()));
      if (fresh) distinct_.push_back(shares);
      numbers.push_back(known->second);
    }
    table_ =
        minimalTable(legal.symbols, numbers, changingConcepts(graph), cardinalityOf(graph), which);
  }

  /// A conditional effect for each row of the table from which the symbol may change.
  std::string text() const {
    std::string text;
    for (const auto& [symbols, number] : table_.rows) {
      const SymbolId own = ownSymbol(symbols);
      const std::string outcomes = outcomesText(own, distinct_[static_cast<std::size_t>(number)]);
      if (outcomes.empty()) continue;
      std::string conditions;
      for (std::size_t i = 0; i < symbols.size(); ++i) {
        conditions += " " + targetFact(table_.concepts[i], symbols[i]);
      }
      text += "\n      (when (and" + conditions + ")\n        (probabilistic" + outcomes + "))";
    }
    return text;
  }

 private:
  SymbolId ownSymbol(const std::vector<SymbolId>& symbols) const {
    const auto own = std::find(table_.concepts.begin(), table_.concepts.end(), which_);
    return symbols[static_cast<std::size_t>(own - table_.concepts.begin())];
  }

  /// Without the outcome that the symbol stays: what is left of one is that.
  std::string outcomesText(SymbolId own, const Shares& shares) const {
    std::string text;
    for (const auto& [next, billionths] : shares) {
      if (billionths == 0 || next == own) continue;
      text += " " + decimalText(billionths) + " (and (not " + targetFact(which_, own) + ") " +
              targetFact(which_, next) + ")";
    }
    return text;
  }

  Concept which_;
  std::vector<Shares> distinct_;
  MinimalTable table_;  // state -> number in distinct_
};

class PpddlWriter {
 public:
  PpddlWriter(const SymbolGraph& graph, const PddlOptions& options)
      : graph_(graph),
        options_(options),
        told_(toldConcepts(graph)),
        domain_(pddlName(options.name)),
        valid_(validTable(graph, true)) {
    const PossibleStates possible(graph);
    for (const Action action : kActions) {
      const double threshold = options.determinisation.legality_threshold;
      const PossibleStates legal = possible.where(graph, action, threshold);
      std::string effects;
      for (const Concept which : changingConcepts(graph)) {
        effects += ConceptEffect(graph, legal, action, which).text();
      }
      if (effects.empty()) continue;
      actions_.push_back({action, legalTable(graph, possible, action, threshold), effects});
    }
  }

  std::string domain() const {
    std::string text =
        "(define (domain " + domain_ +
        ")\n  (:requirements :strips :typing :conditional-effects :probabilistic-effects)\n" +
        typesText(told_) + "  (:constants\n" + symbolsText(graph_, options_) +
        "  )\n  (:predicates\n" + targetPredicates(told_);
    if (!valid_.isConstant()) text += "    " + declaration("valid", valid_.concepts) + "\n";
    for (const PpddlAction& action : actions_) {
      if (action.legal.isConstant()) continue;
      text += "    " + declaration(legalName(action.action), action.legal.concepts) + "\n";
    }
    text += "  )\n";
    for (const PpddlAction& action : actions_) text += actionText(action);
    return text + ")\n";
  }

  std::string problem() const {
    const Symbols goal = mostProbable(graph_.problem().goal);
    std::string text = "(define (problem " + domain_ + ")\n  (:domain " + domain_ +
                       ")\n  (:init\n" + targetFacts(told_, mostProbable(graph_.initialBelief()));
    if (!valid_.isConstant()) text += factsText("valid", valid_);
    for (const PpddlAction& action : actions_) {
      if (!action.legal.isConstant()) text += factsText(legalName(action.action), action.legal);
    }
    text += "  )\n  (:goal (and\n" + targetFacts(told_, goal);
    if (!valid_.isConstant()) {
      text += "    " + factText("valid", valid_.concepts, pick(goal, valid_.concepts)) + "\n";
    }
    return text + "  ))\n)\n";
  }

 private:
  struct PpddlAction {
    Action action;
    MinimalTable legal;
    std::string effects;
  };

  std::string actionText(const PpddlAction& action) const {
    std::vector<Concept> parameters;
    for (const Concept which : kConcepts) {
      for (const std::vector<Concept>& concepts : {action.legal.concepts, valid_.concepts}) {
        if (std::find(concepts.begin(), concepts.end(), which) == concepts.end()) continue;
        parameters.push_back(which);
        break;
      }
    }
    std::string conditions;
    for (const Concept which : parameters) {
      conditions += "\n      " + targetAtom(which, variable(which));
    }
    if (!action.legal.isConstant()) {
      conditions += "\n      " + atomText(legalName(action.action), action.legal.concepts);
    }
    if (!valid_.isConstant()) conditions += "\n      " + atomText("valid", valid_.concepts);
    return "  (:action " + std::string(name(action.action)) + "\n    :parameters (" +
           variables(parameters) + ")\n    :precondition (and" + conditions +
           ")\n    :effect (and" + action.effects + "))\n";
  }

  const SymbolGraph& graph_;
  const PddlOptions& options_;
  std::vector<Concept> told_;
  std::string domain_;
  MinimalTable valid_;  // the start counts as valid
  std::vector<PpddlAction> actions_;
};

}  // namespace

PddlText toPpddl(const SymbolGraph& graph, const PddlOptions& options) {
  checkDeterminisation(options.determinisation);
  const PpddlWriter writer(graph, options);
  return {writer.domain(), writer.problem()};
}

}  // namespace conceptplan
