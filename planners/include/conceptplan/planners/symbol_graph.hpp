#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/planners/state_validity.hpp"
#include "conceptplan/planners/transition.hpp"

namespace conceptplan {

struct CompileOptions {
  /// A concept that every action leaves alone with at least 1 - tolerance is frozen.
  double frozen_tolerance = 1e-3;
  /// Symbols with less than this share of a concept's most probable next symbol are dropped and
  /// the others scaled to one.
  double min_share = 1e-6;
  /// Readings of the other objects with a smaller share of the most probable one are left out.
  double min_reading = 0.01;
  std::size_t max_readings = 12;  ///< >= 1; 1 takes the most probable symbols for true
};

/// Why a concept is not part of the states.
enum class Mutability {
  kChanges,      ///< part of the state
  kFrozenHere,   ///< the model could change it, but not among these objects
  kNeverChanges  ///< no action of the model changes it
};

struct GraphTables;
class SearchGuard;

/// One problem compiled for search: the target's symbols of all concepts that actions change,
/// packed to numbers, with validity, legality and next states tabulated. Immutable; threads may
/// share it. Copies share the tables. What an action does is kept once for all states that agree
/// in what it depends on, so a bench of W x H cells needs a byte a state, a verdict a cell and,
/// where moves depend on nothing but the row or the column, tables of W and of H.
///
/// What is believed of the other objects is part of the state too, though no action changes it:
/// there is a copy of all states for each probable reading of them, that is of their position, of
/// whether they are of a type that some effect takes symbols from, and of these symbols. So a
/// belief over states covers a dyer that may be none, or may stand elsewhere. Else the other
/// objects, and the target's frozen concepts, count with their most probable symbols.
class SymbolGraph {
 public:
  std::size_t numStates() const;
  const SymbolicProblem& problem() const { return problem_; }
  Mutability mutability(Concept which) const;
  std::size_t validityChecks() const;

  /// All six symbols of the state.
  Symbols symbols(StateId state) const;
  /// The state of those symbols in reading 0; frozen concepts are not read.
  StateId state(const Symbols& symbols) const;

  /// Readings of the other objects: 0 has the most probable symbols, the rest fall in share.
  std::size_t numReadings() const;
  std::size_t readingOf(StateId state) const;
  /// Probability of the reading; sums to one.
  double readingShare(std::size_t reading) const;
  /// The state of the same symbols in another reading.
  StateId inReading(StateId state, std::size_t reading) const;

  /// Most probable symbols of start and goal, in reading 0.
  StateId mostProbableStart() const { return state(mostProbable(initialBelief())); }
  StateId mostProbableGoal() const { return state(mostProbable(problem_.goal)); }
  const SymbolBelief& initialBelief() const {
    return problem_.initial.objects[problem_.initial.target];
  }
  /// The same graph for another task of the same target, certain of start and goal.
  SymbolGraph between(StateId start, StateId goal) const;

  const Verdict& verdict(StateId state) const;
  bool valid(StateId state) const;

  /// Pr[a | Omega]; 0 where the action has no effect that is defined.
  double legality(StateId state, Action action) const;

  /// Pr[Omega' | a, Omega] by falling probability, ties by state; sums to one; valid or not.
  TransitionRange transitions(StateId state, Action action) const;

  /// The probability of each state's symbols, [numStates], whatever its reading; frozen concepts
  /// are summed out.
  std::vector<double> stateBelief(const SymbolBelief& belief) const;

  /// Pr[start and goal agree in the concepts that are frozen here although the model could change
  /// them]: a factor of every plan's probability. Concepts that never change are left out, since
  /// they scale all plans alike and reading one of them wrongly must not make a task infeasible.
  double frozenAgreement() const { return frozen_agreement_; }

  /// For the planners of this component, in whose sources they are defined.
  const GraphTables& tables() const { return *tables_; }

 private:
  friend std::optional<SymbolGraph> compile(const SymbolicModel&, const SymbolicProblem&,
                                            const StateValidity&, SearchGuard&,
                                            const CompileOptions&);
  SymbolGraph() = default;

  SymbolicProblem problem_;
  std::shared_ptr<const GraphTables> tables_;
  double frozen_agreement_ = 1;
};

/// @throws std::invalid_argument if the problem does not fit the model: a belief of another
/// cardinality or not a distribution, or a target that is not among the objects; if
/// `max_readings` is 0; or if there are more states than a StateId can number.
SymbolGraph compile(const SymbolicModel& model, const SymbolicProblem& problem,
                    const StateValidity& validity, const CompileOptions& options = {});

/// The same under limits, which it asks for as it goes: nothing once one strikes. @throws as above
std::optional<SymbolGraph> compile(const SymbolicModel& model, const SymbolicProblem& problem,
                                   const StateValidity& validity, SearchGuard& guard,
                                   const CompileOptions& options = {});

}  // namespace conceptplan
