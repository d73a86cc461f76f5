#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "conceptplan/fcl/fcl_scene.hpp"
#include "conceptplan/planners/state_validity.hpp"

namespace conceptplan {

struct FclValidityOptions {
  /// Clearance that must remain between two objects, metres; > 0, since FCL is unreliable on
  /// shapes that touch exactly.
  double margin_m = 0.002;
  /// Footprints count up to this share of a cell's edge from its middle. In (0, 0.5).
  double max_half_width_cells = kMaxHalfWidthCells;
};

/// Validity by collision geometry: convex prisms of the measured footprints, of each type at its
/// size and rotation, at the centres of the cells that the position symbols stand for, against each
/// other and the workbench's edge. A footprint without a measure and whatever FCL throws give
/// `Invalidity::kCheckFailed`; what `contactOf` calls touching is a collision.
/// `Verdict::clearance_m` is the distance to the nearest object or edge. Thread-safe.
class FclValidity final : public StateValidity {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit FclValidity(const FclValidityOptions& options = {});

  Verdict check(const Workbench& workbench, const SymbolGrounding& grounding, const Symbols& target,
                std::span<const Symbols> others) const override;
  std::vector<Verdict> checkAll(const Workbench& workbench, const SymbolGrounding& grounding,
                                std::span<const Symbols> targets,
                                std::span<const Symbols> others) const override;
  std::array<bool, kNumConcepts> dependsOn() const override;

  /// Whether the target can be pushed straight from one state to another; on all the way it
  /// covers what it covers in either. @pre all symbols are below the cardinality of the grounding.
  Verdict checkMotion(const Workbench& workbench, const SymbolGrounding& grounding,
                      const Symbols& from, const Symbols& to,
                      std::span<const Symbols> others) const;

  /// The other objects of a scene, for many questions.
  FclScene sceneOf(const Workbench& workbench, const SymbolGrounding& grounding,
                   std::span<const Symbols> others) const;

 private:
  FclValidityOptions options_;
  std::shared_ptr<PrismShapes> shapes_;
};

}  // namespace conceptplan
