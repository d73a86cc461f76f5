#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "conceptplan/planners/search_guard.hpp"
#include "conceptplan/planners/state_path.hpp"
#include "graph_tables.hpp"
#include "path_rank.hpp"

namespace conceptplan {

/// One way out of a state.
struct Successor {
  Action action{};
  StateId state{};
  PathCost cost = 0;  ///< >= 0; a PathRank for the searches that order by it
};

/// Replaces the vector's content by all ways out of the state, in the order of `kActions`.
using SuccessorFunction = std::function<void(StateId, std::vector<Successor>&)>;

/// A problem over single states, made from a graph by choosing which outcomes of actions a planner
/// may take and what they cost. Left out: actions whose legality does not exceed the threshold,
/// steps that change nothing and, by the `SuccessorFunction`, those to states that are not valid.
/// Steps are worked out once for all states that agree in what an action depends on. Keeps a
/// reference to the graph.
class StateSteps {
 public:
  /// A step in all states of one context of its action.
  struct Step {
    Action action;
    std::int32_t shift;  ///< from the number of the state to that of the next one
    PathCost cost;       ///< as that of a Successor
  };

  /// The steps of actions that follow each other and depend on the same concepts.
  struct ContextSteps {
    SymbolIndex contexts;
    std::vector<std::uint32_t> first;  ///< [contexts + 1], where the steps of each context begin
    std::vector<Step> steps;           ///< of each context by action
  };

  /// @param steps adds those of the outcomes of a legal action.
  using Choice = std::function<void(Action, std::span<const Outcome>, std::vector<Step>& steps)>;

  /// @param guard once it has been stopped, the steps have no use; null: nothing stops it
  StateSteps(const SymbolGraph& graph, double legality_threshold, const Choice& choice,
             SearchGuard* guard = nullptr);

  bool valid(StateId state) const { return graph_.valid[index(state)] != 0; }

  /// Calls `visit` with each step out of the state, also those to states that are not valid.
  template <typename Visitor>
  void forEach(StateId state, Visitor visit) const {
    const Symbols symbols = graph_.symbols(state);
    for (const ContextSteps& all : steps_[graph_.readingOf(state)]) {
      const std::size_t context = all.contexts(symbols);
      const Step* const end = all.steps.data() + all.first[context + 1];
      for (const Step* step = all.steps.data() + all.first[context]; step != end; ++step) {
        const auto to = static_cast<StateId>(static_cast<std::int32_t>(state) + step->shift);
        visit(Successor{step->action, to, step->cost});
      }
    }
  }

  void operator()(StateId state, std::vector<Successor>& next) const {
    next.clear();
    forEach(state, [&](const Successor& step) {
      if (valid(step.state)) next.push_back(step);
    });
  }

  /// The same steps at other costs, in one reading alone.
  /// @param cost of a step from the state of this number among those of the reading, or from any
  /// other in the same context; kOutOfReach leaves it out.
  /// @param guard as of the constructor
  StateSteps atCosts(std::size_t reading,
                     const std::function<PathCost(std::size_t from, const Step&)>& cost,
                     SearchGuard* guard = nullptr) const;

  /// All steps of the reading, where they are valid and where they are not.
  const std::vector<ContextSteps>& ofReading(std::size_t reading) const { return steps_[reading]; }

 private:
  explicit StateSteps(const GraphTables& graph) : graph_(graph), steps_(graph.readings.size()) {}

  const GraphTables& graph_;
  std::vector<std::vector<ContextSteps>> steps_;  // [readings]
};

/// A `SuccessorFunction` as steps that can be visited. For one thread.
class FunctionSteps {
 public:
  explicit FunctionSteps(SuccessorFunction successors) : successors_(std::move(successors)) {}

  bool valid(StateId) const { return true; }

  template <typename Visitor>
  void forEach(StateId state, Visitor visit) const {
    successors_(state, next_);
    for (const Successor& step : next_) visit(step);
  }

  void operator()(StateId state, std::vector<Successor>& next) const { successors_(state, next); }

 private:
  SuccessorFunction successors_;
  mutable std::vector<Successor> next_;
};

/// The problem in which every action has its most probable outcome (single-outcome
/// determinisation), at the cost given.
/// Source: S. Yoon, A. Fern and R. Givan, FF-Replan, ICAPS 2007.
/// @param guard here and below as of `StateSteps`
StateSteps likelySuccessors(const SymbolGraph& graph, double legality_threshold,
                            const std::function<PathCost(const Outcome&)>& cost,
                            SearchGuard* guard = nullptr);

/// As above with the cost `-log Pr[outcome] - log(1 - step_discount)`: the cost of a path is the
/// negative logarithm of its discounted probability.
StateSteps likelySuccessors(const SymbolGraph& graph, double legality_threshold,
                            double step_discount, SearchGuard* guard = nullptr);

/// The same with PathRanks as costs, for the searches that order by them.
StateSteps rankedSuccessors(const SymbolGraph& graph, double legality_threshold,
                            double step_discount, SearchGuard* guard = nullptr);

/// The problem in which the planner may choose among the outcomes of an action; every step costs
/// one nat. Its distances never exceed those of the problem itself.
StateSteps anyOutcomeSuccessors(const SymbolGraph& graph, double legality_threshold,
                                SearchGuard* guard = nullptr);

}  // namespace conceptplan
