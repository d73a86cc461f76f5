#pragma once

#include <cstdint>

#include "conceptplan/domain/model/symbolic_model.hpp"

namespace conceptplan::testing {

/// A workbench of any size on which four sure moves and two sure turns work.
struct GridWorld {
  SymbolicModel model;
  SymbolicProblem problem;  ///< from the first cell to the last one, half a turn away
};

/// @param obstacle_share of the cells, drawn; the first and the last cell stay free.
GridWorld gridWorld(int columns, int rows, int rotations, double obstacle_share,
                    std::uint64_t seed);

}  // namespace conceptplan::testing
