#include "planners/obstacle_map.hpp"

#include "conceptplan/domain/simulation/random_stream.hpp"

namespace conceptplan::testing {

ObstacleMap::ObstacleMap(int columns, int rows, double share, std::uint64_t seed)
    : columns_(static_cast<std::size_t>(columns)),
      taken_(columns_ * static_cast<std::size_t>(rows), false) {
  RandomStream draws({seed, 29});
  for (std::size_t cell = 1; cell + 1 < taken_.size(); ++cell) {
    taken_[cell] = static_cast<double>(draws.below(1000)) < 1000 * share;
  }
}

Verdict ObstacleMap::check(const Workbench& workbench, const SymbolGrounding& grounding,
                           const Symbols& target, std::span<const Symbols> others) const {
  const Verdict verdict = GridValidity().check(workbench, grounding, target, others);
  if (!verdict.valid()) return verdict;
  const Cell cell = grounding.cell(target);
  const bool taken =
      taken_[static_cast<std::size_t>(cell.y) * columns_ + static_cast<std::size_t>(cell.x)];
  return taken ? Verdict{Invalidity::kWorkbenchEdge, 0, 0} : Verdict{};
}

std::array<bool, kNumConcepts> ObstacleMap::dependsOn() const { return GridValidity().dependsOn(); }

}  // namespace conceptplan::testing
