#pragma once

#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/domain/symbols.hpp"

namespace conceptplan::testing {

/// A world small enough to be summed by hand: three columns in one row, two rotations, two colours,
/// two types (0 target, 1 dyer). move_right slips and stays with 0.2, move_left is sure,
/// rotate_left works with 0.9, change_color takes the colour of the nearest object of type 1.
/// move_right is not legal in column 2, move_left not in column 0.
SymbolicModel tinyModel();

inline constexpr ConceptCardinality kTinyCardinality{2, 3, 1, 2, 2, 1};

/// Symbols of an object of the tiny world.
Symbols tinySymbols(int type, int column, int rotation, int color);

/// A bench of 3 x 1 cells with the target alone, certain of start and goal.
SymbolicProblem tinyProblem(const Symbols& start, const Symbols& goal);

}  // namespace conceptplan::testing
