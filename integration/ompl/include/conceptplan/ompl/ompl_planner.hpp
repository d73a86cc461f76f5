#pragma once

#include <cstddef>

#include "conceptplan/planners/planner.hpp"
#include "conceptplan/planners/planner_registry.hpp"

namespace conceptplan {

/// OMPL's planners for systems with controls.
enum class OmplAlgorithm { kRrt, kEst, kKpiece, kSst, kPdst, kSyclopRrt };

struct OmplPlannerOptions {
  double legality_threshold = 0.01;  ///< in [0, 1]
  double goal_bias = 0.05;           ///< share of samples drawn at the goal, in [0, 1]; not Syclop
  /// Actions tried to come near a sample, >= 1; the best is taken. Not KPIECE and SST.
  std::size_t control_samples = 3;
  std::size_t improvement_steps = 500;  ///< SST goes on for so many steps after its first plan
};

/// Samples for plans from the most probable start to the most probable goal, where each action has
/// its most probable outcome, with a planner of OMPL.
///
/// A breadth-first search, given half of the expansions, proves first that there is no plan. Then
/// one run is made for each plan asked for, and more while none is found; a step of a run counts as
/// an expansion. Each path found is replayed on the graph and shortened: where one action joins two
/// of its states, what lies between is left out.
///
/// The same seed gives the same plans in any thread, as long as no time limit strikes: every
/// generator of OMPL that a run draws from is seeded by itself. OMPL's generator of the process is
/// not seeded, but OMPL draws a seed from it for each generator that it makes.
class OmplPlanner final : public Planner {
 public:
  /// @throws std::invalid_argument if an option is out of range.
  explicit OmplPlanner(OmplAlgorithm algorithm, const OmplPlannerOptions& options = {});

 private:
  PlanResult search(const SymbolGraph& graph, const PlanQuery& query) const override;

  OmplAlgorithm algorithm_;
  OmplPlannerOptions options_;
};

/// Adds `ompl-rrt`, `ompl-est`, `ompl-kpiece`, `ompl-sst`, `ompl-pdst` and `ompl-syclop-rrt`.
/// @throws std::invalid_argument if one of the names is taken.
void addOmplPlanners(PlannerRegistry& registry);

}  // namespace conceptplan
