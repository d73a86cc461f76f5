#pragma once

#include <atomic>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "conceptplan/nlopt/motion_task.hpp"

namespace conceptplan {

struct RefinementOptions {
  /// To keep to every other object and to the workbench's edge, metres, in [0, 1].
  double clearance_m = 0.01;
  std::string algorithm = "slsqp";  ///< one of `refinementAlgorithms`
  double action_s = 1;              ///< duration of each action, > 0
  /// What an integrated squared jerk of 1 m^2/s^5 may cost in length, s^5/m, >= 0.
  double jerk_weight = 1e-3;
  /// A step in place happens within this share of the cell's edge from the cell's centre along
  /// each axis, in [0, 0.5).
  double cell_reach = 0.25;
  double max_lift_m = 0.4;    ///< >= 0; 0: the target is always pushed
  int max_evaluations = 300;  ///< of objective and constraints, in one solution, >= 1
  /// Of the whole refinement, > 0; once it strikes, the discrete plan is the answer.
  double timeout_s = std::numeric_limits<double>::infinity();
  const std::atomic<bool>* cancel = nullptr;  ///< the same soon after it turns true
};

/// What came of a refinement.
struct RefinementResult {
  Trajectory trajectory;    ///< the discrete plan's if it fell back
  double length_m = 0;      ///< of the way over the workbench, seen from above
  double clearance_m = 0;   ///< measured, as `clearance_m` of a task does
  bool fell_back = false;   ///< the trajectory is the discrete plan as it was
  std::string reason;       ///< why it fell back; empty if it did not
  double lift_m = 0;        ///< greatest lift; 0 where the target is pushed all the way
  double squared_jerk = 0;  ///< m^2/s^5
  double discrete_length_m = 0;
  double discrete_clearance_m = 0;
  int evaluations = 0;  ///< of objective and constraints
};

/// A solver of the refinement by name.
struct RefinementAlgorithm {
  std::string_view name;
  std::string_view summary;  ///< one line
  std::string_view source;   ///< citation
};

/// slsqp, mma, ccsaq and cobyla: the local algorithms of NLopt that take inequality constraints.
const std::vector<RefinementAlgorithm>& refinementAlgorithms();

/// Turns a symbolic plan into a smooth motion: of least length and jerk, clear of all else, with
/// what the plan does in its places kept. Start and goal are the plan's and at rest; step i takes
/// the time from i to i + 1 times `action_s`; a step in place stays within its cell for that time,
/// and turns by what the plan turns. Where the asked clearance cannot be kept by pushing, the
/// target is lifted on the way between two places.
///
/// What is answered keeps the asked clearance, measured and not only solved for, and is no longer
/// than the discrete plan; else it is the discrete plan, and says so. Thread-safe and, unless the
/// time limit strikes, deterministic. Formulas: docs/equations.md, "Refinement".
class Refiner {
 public:
  /// @throws std::invalid_argument if an option is out of range or the algorithm unknown.
  explicit Refiner(const RefinementOptions& options = {});

  /// @throws std::invalid_argument if the task has no waypoint or a body is not measured.
  RefinementResult refine(const MotionTask& task) const;

 private:
  RefinementOptions options_;
};

}  // namespace conceptplan
