#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "conceptplan/domain/concept.hpp"
#include "conceptplan/domain/workbench.hpp"

namespace conceptplan {

/// A cluster of one concept's tokens, in [0, number of clusters). Its number means nothing: what a
/// symbol stands for is in `SymbolGrounding`.
enum class SymbolId : std::int32_t {};

constexpr std::size_t index(SymbolId symbol) { return static_cast<std::size_t>(symbol); }

/// One symbol a concept: the paper's Omega = {omega^k}. Source: Sec. III-B of arXiv 2310.03325.
using Symbols = std::array<SymbolId, kNumConcepts>;

/// A distribution over the symbols of each concept; each sums to one.
using SymbolBelief = std::array<std::vector<double>, kNumConcepts>;

/// The most probable symbol of each concept; ties go to the lower number.
Symbols mostProbable(const SymbolBelief& belief);

/// The belief that is certain of the symbols. @pre each symbol is below its cardinality
SymbolBelief certain(const Symbols& symbols,
                     const std::array<std::size_t, kNumConcepts>& cardinality);

/// What is believed of the objects on a workbench.
struct SymbolicScene {
  Workbench workbench;
  std::vector<SymbolBelief> objects;
  std::size_t target = 0;  ///< index into `objects`
};

/// All that a planner is told of a task: where it starts and what the target should become.
struct SymbolicProblem {
  SymbolicScene initial;
  SymbolBelief goal;
};

/// An object to be moved, and what it should become.
struct TargetGoal {
  std::size_t object = 0;  ///< index into the objects of the problem
  SymbolBelief goal;
  std::string name = "";  ///< what a reason calls the object; empty: its index
};

/// A task of several targets on one workbench. Each action moves one of them; the others stand
/// still meanwhile, and are in its way.
struct JointProblem {
  Workbench workbench;
  std::vector<SymbolBelief> objects;
  std::vector<TargetGoal> targets;  ///< at least one; each another object
};

}  // namespace conceptplan
