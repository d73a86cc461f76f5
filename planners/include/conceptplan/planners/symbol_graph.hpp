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
};

/// Why a concept is not part of the states.
enum class Mutability {
  kChanges,      ///< part of the state
  kFrozenHere,   ///< the model could change it, but not among these objects
  kNeverChanges  ///< no action of the model changes it
};

/// One problem compiled for search: the target's symbols of all concepts that actions change,
/// packed to numbers, with validity, legality and next states tabulated. The other objects count
/// with their most probable symbols, the target's frozen concepts too. Immutable; threads may
/// share it.
class SymbolGraph {
 public:
  std::size_t numStates() const { return verdicts_.size(); }
  const SymbolicProblem& problem() const { return problem_; }
  Mutability mutability(Concept which) const { return mutability_[index(which)]; }
  std::size_t validityChecks() const { return validity_checks_; }

  /// All six symbols of the state.
  Symbols symbols(StateId state) const;
  /// The state of those symbols; frozen concepts are not read.
  StateId state(const Symbols& symbols) const;

  /// Most probable symbols of start and goal.
  StateId mostProbableStart() const { return state(mostProbable(initialBelief())); }
  StateId mostProbableGoal() const { return state(mostProbable(problem_.goal)); }
  const SymbolBelief& initialBelief() const {
    return problem_.initial.objects[problem_.initial.target];
  }

  const Verdict& verdict(StateId state) const { return verdicts_[index(state)]; }
  bool valid(StateId state) const { return verdict(state).valid(); }

  /// Pr[a | Omega]; 0 where the action has no effect that is defined.
  double legality(StateId state, Action action) const { return legality_[edge(state, action)]; }

  /// Pr[Omega' | a, Omega] by falling probability, ties by state; sums to one; valid or not.
  std::span<const Transition> transitions(StateId state, Action action) const;

  /// The belief over states that a belief over symbols gives, [numStates]; frozen concepts are
  /// summed out.
  std::vector<double> stateBelief(const SymbolBelief& belief) const;

  /// Pr[start and goal agree in the concepts that are frozen here although the model could change
  /// them]: a factor of every plan's probability. Concepts that never change are left out, since
  /// they scale all plans alike and reading one of them wrongly must not make a task infeasible.
  double frozenAgreement() const { return frozen_agreement_; }

 private:
  friend SymbolGraph compile(const SymbolicModel&, const SymbolicProblem&, const StateValidity&,
                             const CompileOptions&);
  SymbolGraph() = default;
  std::size_t edge(StateId state, Action action) const {
    return index(state) * kNumActions + index(action);
  }

  SymbolicProblem problem_;
  Symbols frozen_{};
  std::array<Mutability, kNumConcepts> mutability_{};
  std::array<std::size_t, kNumConcepts> stride_{};  // 0 for frozen concepts
  ConceptCardinality cardinality_{};
  std::vector<Verdict> verdicts_;
  std::vector<double> legality_;
  std::vector<std::size_t> first_transition_;
  std::vector<Transition> transitions_;
  std::size_t validity_checks_ = 0;
  double frozen_agreement_ = 1;
};

/// @throws std::invalid_argument if the problem does not fit the model: a belief of another
/// cardinality or not a distribution, or a target that is not among the objects.
SymbolGraph compile(const SymbolicModel& model, const SymbolicProblem& problem,
                    const StateValidity& validity, const CompileOptions& options = {});

}  // namespace conceptplan
