#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/planners/search_guard.hpp"
#include "successors.hpp"

namespace conceptplan {

/// A state of one target of a joint problem, in [0, numStates).
using TargetState = std::uint32_t;

/// An action on one target with its most probable outcome.
struct TargetStep {
  Action action{};
  TargetState next = 0;
  double probability = 1;  ///< of the outcome
  PathCost cost = 0;
};

/// Which steps there are, and what they cost.
struct StepRules {
  double legality_threshold = 0;
  double min_share = 0;         ///< as in CompileOptions
  double frozen_tolerance = 0;  ///< as in CompileOptions
  std::function<PathCost(double probability)> cost;
};

/// One target of a joint problem: its symbols of the concepts that actions on it change, packed to
/// numbers, and what may become of them. Keeps a reference to the model.
class JointTarget {
 public:
  /// @param scene most probable symbols of all objects at the start
  /// @param moves which of them are targets
  /// @param object the one that this is about
  /// @param guard once it has been stopped, the target has no use
  JointTarget(const SymbolicModel& model, std::span<const Symbols> scene,
              const std::vector<bool>& moves, std::size_t object, StepRules rules,
              SearchGuard& guard);

  std::size_t numStates() const { return possible_.size(); }
  bool isPart(Concept which) const { return stride_[index(which)] != 0; }
  /// Whether the model changes the concept, but not among these objects.
  bool isFrozenHere(Concept which) const { return frozen_here_[index(which)]; }

  /// All symbols of a state; concepts that are no part of it have those of the start.
  Symbols symbols(TargetState state) const;
  TargetState state(const Symbols& symbols) const;

  /// Whether its steps depend on where an object is that moves too, or on that one's symbols.
  bool watches(std::size_t object) const { return watched_[object]; }

  /// Every step that there is with the other targets at some place, with some symbols. Where it
  /// watches none of them, these are the steps themselves.
  std::span<const TargetStep> possibleSteps(TargetState state) const { return possible_[state]; }

  /// Pr[a | Omega] among other objects with these symbols; 0 where the action has no effect that is
  /// defined.
  double legality(TargetState state, Action action, std::span<const Symbols> others) const;
  bool isLegal(double probability) const { return probability > rules_.legality_threshold; }

  /// The steps among other objects with these symbols, in the order of `kActions`. Left out:
  /// actions whose legality does not exceed the threshold, and steps that change nothing.
  std::vector<TargetStep> steps(TargetState state, std::span<const Symbols> others) const;

 private:
  const SymbolicModel& model_;
  StepRules rules_;
  Symbols start_{};
  std::array<std::size_t, kNumConcepts> stride_{};  // 0 for concepts that are no part
  std::array<bool, kNumConcepts> frozen_here_{};
  std::vector<bool> watched_;
  std::vector<std::vector<TargetStep>> possible_;
};

}  // namespace conceptplan
