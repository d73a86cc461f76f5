#pragma once

#include <cstdint>

#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan::testing {

/// The model of `randomWorld(seed)`.
SymbolicModel randomModel(std::uint64_t seed);

/// A small world drawn at random: three columns, two rows, two rotations; actions that go wrong
/// and are illegal where chance has it; up to two obstacles that may shut the target in. Start and
/// goal are certain, or believed with drawn probabilities if `uncertain`.
SymbolGraph randomWorld(std::uint64_t seed, bool uncertain = false);

}  // namespace conceptplan::testing
