#pragma once

#include <memory>
#include <vector>

#include "conceptplan/domain/model/upright_prism.hpp"
#include "conceptplan/planners/state_validity.hpp"

namespace conceptplan {

class PrismShapes;

/// The objects of one workbench in FCL's tree of bounding boxes, for many questions about one
/// target among them. Immutable and thread-safe; answers as `FclValidity` does.
class FclScene {
 public:
  /// @param margin_m must remain between two objects, > 0
  /// @param shapes to share with other scenes; null: its own
  /// @throws std::invalid_argument if the margin is out of range.
  FclScene(const Workbench& workbench, std::vector<UprightPrism> others, double margin_m,
           std::shared_ptr<PrismShapes> shapes = nullptr);
  ~FclScene();
  FclScene(FclScene&&) noexcept;
  FclScene& operator=(FclScene&&) noexcept;

  /// Whether the target can stand there.
  Verdict check(const UprightPrism& target) const;

  /// Whether the target can go straight from where it stands to `p_WTo`: all that it sweeps is
  /// asked for, not a number of poses. The clearance is the least on the way.
  Verdict checkMotion(const UprightPrism& target, const Eigen::Vector2d& p_WTo) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

}  // namespace conceptplan
