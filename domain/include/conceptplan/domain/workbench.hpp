#pragma once

#include <Eigen/Core>

#include "conceptplan/domain/object.hpp"

namespace conceptplan {

/// A workbench of square cells. Frame W has its origin at the centre of the top surface, x to the
/// right, y away from the camera and z up.
struct Workbench {
  int columns = 3;
  int rows = 5;
  double cell_m = 0.2;

  bool contains(Cell cell) const {
    return cell.x >= 0 && cell.x < columns && cell.y >= 0 && cell.y < rows;
  }

  /// Centre of the cell on the surface, in W, metres.
  Eigen::Vector2d p_WCell(Cell cell) const {
    return {(cell.x - 0.5 * (columns - 1)) * cell_m, (cell.y - 0.5 * (rows - 1)) * cell_m};
  }

  bool operator==(const Workbench&) const = default;
};

}  // namespace conceptplan
