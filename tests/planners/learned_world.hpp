#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/domain/symbols.hpp"
#include "conceptplan/domain/task.hpp"
#include "conceptplan/learner/transitions/transition_estimation.hpp"

namespace conceptplan::testing {

/// Names the true values of concepts by symbols in an arbitrary order, as clustering does: what a
/// perfect perception would give. Types never seen in training look like seen ones.
class Relabelling {
 public:
  /// @param seed of the order; 0 leaves every value its own number.
  explicit Relabelling(std::uint64_t seed);

  Symbols symbols(const ObjectState& object) const;
  SymbolId symbol(Concept which, int value) const;
  SymbolGrounding grounding() const;

  /// All objects certain of their symbols.
  SymbolicProblem problem(const Task& task) const;

 private:
  std::array<std::vector<SymbolId>, kNumConcepts> symbol_of_;
};

/// The steps of the reference plans of training tasks of the levels, as symbols; each symbol is
/// replaced by another one with probability `misread`.
std::vector<Triplet> trainingTriplets(const Relabelling& relabelling,
                                      const std::vector<int>& levels, int tasks_per_level,
                                      double misread, std::uint64_t seed);

/// A model learned from 500 tasks of each level, read without error; made once a process.
const SymbolicModel& learnedModel();

/// The relabelling of `learnedModel`.
const Relabelling& learnedRelabelling();

}  // namespace conceptplan::testing
