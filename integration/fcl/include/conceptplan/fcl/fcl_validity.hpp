#pragma once

#include <array>
#include <span>

#include "conceptplan/planners/state_validity.hpp"

namespace conceptplan {

struct FclValidityOptions {
  /// Clearance that must remain between two objects, metres; > 0, since FCL is unreliable on
  /// shapes that touch exactly.
  double margin_m = 0.002;
  /// Footprints count up to this share of a cell's edge; what a handle sticks out further passes
  /// over its neighbour. In (0, 0.5).
  double max_radius_cells = 0.48;
};

/// Validity by collision geometry: upright cylinders of the measured footprints at the centres of
/// the cells that the position symbols stand for, against each other and the workbench's edge.
/// The target is grown by the margin and FCL asked whether it meets another cylinder, without
/// contacts; a footprint without a measure and whatever FCL throws give `Invalidity::kCheckFailed`.
/// `Verdict::clearance_m` is the distance to the nearest object or edge. Thread-safe.
///
/// FCL's distance query is left out with intent: its GJK aborts the process on an assertion for
/// some poses (FCL 0.7, gjk_libccd-inl.h, doSimplex2).
class FclValidity final : public StateValidity {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit FclValidity(const FclValidityOptions& options = {});

  Verdict check(const Workbench& workbench, const SymbolGrounding& grounding, const Symbols& target,
                std::span<const Symbols> others) const override;
  std::array<bool, kNumConcepts> dependsOn() const override;

 private:
  FclValidityOptions options_;
};

}  // namespace conceptplan
