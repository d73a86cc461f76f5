#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace conceptplan::testing {

/// A tree of words in parentheses.
struct PddlExpression {
  std::string word;  ///< empty for a list
  std::vector<PddlExpression> list;

  const std::string& head() const;
};

/// A planning task read from PDDL or PPDDL text, strictly and without any of the library's code:
/// all that is used must be declared, with the types and requirements declared for it.
class PddlTask {
 public:
  using State = std::set<std::string>;  ///< the facts that actions change

  struct Outcome {
    State state;
    double probability = 0;
  };
  struct Step {
    std::string text;  ///< "(move_left position_x-1 position_x-0)"
    std::vector<Outcome> outcomes;
    std::int64_t cost = 0;
  };
  struct Solution {
    std::vector<std::string> steps;
    std::int64_t cost = 0;
    std::size_t expanded = 0;
  };

  /// @throws std::runtime_error with what is wrong.
  PddlTask(const std::string& domain, const std::string& problem);

  State initial() const;
  bool isGoal(const State& state) const;
  /// All actions that are applicable, by action, then by arguments.
  std::vector<Step> steps(const State& state) const;
  std::size_t numFacts() const { return facts_.size(); }

  /// A cheapest plan by Dijkstra's algorithm; nothing if there is none.
  /// @pre no action has several outcomes
  std::optional<Solution> solve() const;

 private:
  using Words = std::vector<std::string>;
  using Binding = std::map<std::string, std::string>;  // variable -> object
  struct Parameter {
    std::string name;
    std::string type;
  };
  struct Schema {
    std::string name;
    std::vector<Parameter> parameters;
    std::vector<PddlExpression> conditions;
    PddlExpression effect;
  };
  struct GroundAction {
    const Schema* schema;
    Binding binding;
    Words conditions;  // changing facts that must hold
  };
  struct Change {
    State added;
    State deleted;
    double probability = 1;
  };

  void readDomain(const PddlExpression& domain);
  void readProblem(const PddlExpression& problem);
  void readAction(const PddlExpression& action);
  void declareObjects(const PddlExpression& section);
  void checkAtom(const PddlExpression& atom, const std::vector<Parameter>& variables,
                 const std::map<std::string, Words>& declared) const;
  void checkEffect(const PddlExpression& effect, const std::vector<Parameter>& variables);
  void ground(const Schema& schema, Binding& binding);
  std::vector<Change> changes(const PddlExpression& effect, const Binding& binding,
                              const State& state) const;
  std::int64_t costOf(const PddlExpression& effect, const Binding& binding) const;

  std::set<std::string> requirements_;
  std::set<std::string> types_;
  std::map<std::string, Words> predicates_;  // name -> types of arguments
  std::map<std::string, Words> functions_;
  std::map<std::string, std::string> objects_;  // name -> type
  std::vector<Schema> schemas_;
  std::set<std::string> changing_;  // predicates in effects
  std::set<std::string> facts_;
  std::map<std::string, std::int64_t> values_;
  std::vector<PddlExpression> goal_;
  std::vector<GroundAction> actions_;
};

}  // namespace conceptplan::testing
