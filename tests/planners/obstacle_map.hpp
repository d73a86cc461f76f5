#pragma once

#include <cstdint>
#include <vector>

#include "conceptplan/planners/state_validity.hpp"

namespace conceptplan::testing {

/// Obstacles as holes in the workbench, for benches with more of them than a list of objects can
/// hold.
class ObstacleMap final : public StateValidity {
 public:
  /// @param share of the cells, drawn; the first and the last cell stay free.
  ObstacleMap(int columns, int rows, double share, std::uint64_t seed);

  Verdict check(const Workbench& workbench, const SymbolGrounding& grounding, const Symbols& target,
                std::span<const Symbols> others) const override;
  std::array<bool, kNumConcepts> dependsOn() const override;

 private:
  std::size_t columns_;
  std::vector<bool> taken_;  // [rows, columns]
};

}  // namespace conceptplan::testing
