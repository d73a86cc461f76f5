#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/planners/state_validity.hpp"

namespace conceptplan {

/// A state of a SymbolGraph, in [0, numStates).
enum class StateId : std::int32_t {};

constexpr std::size_t index(StateId state) { return static_cast<std::size_t>(state); }

/// One possible next state.
struct Transition {
  StateId state{};
  double probability = 0;  ///< in (0, 1]
  double cost = 0;         ///< -log probability
};

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

/// One problem compiled for search: the target's symbols of all concepts that actions change,
/// packed to numbers, with validity, legality and next states tabulated. Immutable; threads may
/// share it.
///
/// What is believed of the other objects is part of the state too, though no action changes it:
/// there is a copy of all states for each probable reading of them, that is of their position, of
/// whether they are of a type that some effect takes symbols from, and of these symbols. So a
/// belief over states covers a dyer that may be none, or may stand elsewhere. Else the other
/// objects, and the target's frozen concepts, count with their most probable symbols.
class SymbolGraph {
 public:
  std::size_t numStates() const { return verdicts_.size(); }
  const SymbolicProblem& problem() const { return problem_; }
  Mutability mutability(Concept which) const { return mutability_[index(which)]; }
  std::size_t validityChecks() const { return validity_checks_; }

  /// All six symbols of the state.
  Symbols symbols(StateId state) const;
  /// The state of those symbols in reading 0; frozen concepts are not read.
  StateId state(const Symbols& symbols) const;

  /// Readings of the other objects: 0 has the most probable symbols, the rest fall in share.
  std::size_t numReadings() const { return reading_shares_.size(); }
  std::size_t readingOf(StateId state) const { return index(state) / statesPerReading(); }
  /// Probability of the reading; sums to one.
  double readingShare(std::size_t reading) const { return reading_shares_[reading]; }
  /// The state of the same symbols in another reading.
  StateId inReading(StateId state, std::size_t reading) const {
    return static_cast<StateId>(index(state) % statesPerReading() + reading * statesPerReading());
  }

  /// Most probable symbols of start and goal, in reading 0.
  StateId mostProbableStart() const { return state(mostProbable(initialBelief())); }
  StateId mostProbableGoal() const { return state(mostProbable(problem_.goal)); }
  const SymbolBelief& initialBelief() const {
    return problem_.initial.objects[problem_.initial.target];
  }
  /// The same graph for another task of the same target, certain of start and goal.
  SymbolGraph between(StateId start, StateId goal) const;

  const Verdict& verdict(StateId state) const { return verdicts_[index(state)]; }
  bool valid(StateId state) const { return verdict(state).valid(); }

  /// Pr[a | Omega]; 0 where the action has no effect that is defined.
  double legality(StateId state, Action action) const { return legality_[edge(state, action)]; }

  /// Pr[Omega' | a, Omega] by falling probability, ties by state; sums to one; valid or not.
  std::span<const Transition> transitions(StateId state, Action action) const;

  /// The probability of each state's symbols, [numStates], whatever its reading; frozen concepts
  /// are summed out.
  std::vector<double> stateBelief(const SymbolBelief& belief) const;

  /// Pr[start and goal agree in the concepts that are frozen here although the model could change
  /// them]: a factor of every plan's probability. Concepts that never change are left out, since
  /// they scale all plans alike and reading one of them wrongly must not make a task infeasible.
  double frozenAgreement() const { return frozen_agreement_; }

 private:
  friend SymbolGraph compile(const SymbolicModel&, const SymbolicProblem&, const StateValidity&,
                             const CompileOptions&);
  SymbolGraph() = default;
  std::size_t statesPerReading() const { return numStates() / numReadings(); }
  std::size_t edge(StateId state, Action action) const {
    return index(state) * kNumActions + index(action);
  }

  SymbolicProblem problem_;
  Symbols frozen_{};
  std::array<Mutability, kNumConcepts> mutability_{};
  std::array<std::size_t, kNumConcepts> stride_{};  // 0 for frozen concepts
  ConceptCardinality cardinality_{};
  std::vector<double> reading_shares_;
  std::vector<Verdict> verdicts_;
  std::vector<double> legality_;
  std::vector<std::size_t> first_transition_;
  std::vector<Transition> transitions_;
  std::size_t validity_checks_ = 0;
  double frozen_agreement_ = 1;
};

/// @throws std::invalid_argument if the problem does not fit the model: a belief of another
/// cardinality or not a distribution, or a target that is not among the objects; or if
/// `max_readings` is 0.
SymbolGraph compile(const SymbolicModel& model, const SymbolicProblem& problem,
                    const StateValidity& validity, const CompileOptions& options = {});

}  // namespace conceptplan
