#pragma once

#include <cstdint>

#include "conceptplan/domain/task.hpp"

namespace conceptplan {

/// Which tasks to draw.
struct TaskOptions {
  int level = 1;  ///< in [1, 4]
  Split split = Split::kTrain;
  ObjectSet objects = ObjectSet::kSeen;  ///< types of target and obstacles; a dyer is a Dyer
  /// `kUnseenTask`: no plan of the train split is held out, at any level, and every plan of the
  /// other splits is, at levels 1 and 2 only; see `isHeldOut`.
  Combination combination = Combination::kAll;
  std::uint64_t seed = 0;
};

/// Draws causal planning tasks on 3 x 5 cells. Source: Sec. II-B of arXiv 2310.03325; the draws
/// below give its mean lengths 2.67, 2.81, 4.66 and 5.64.
///
/// Level 1: the target goes to another cell, both uniform. Level 2: two obstacles in other cells.
/// Level 3: also a dyer; in 75 % of the tasks the goal has the dyer's colour, which the target has
/// not yet. Level 4: also a goal rotation uniform over the quarter turns. Arrangements without a
/// plan are drawn again. Types, colours, sizes and rotations of all objects are uniform. The
/// reference is drawn uniformly from the shortest plans. Under `kUnseenTask`, tasks whose reference
/// is of the other kind are drawn again too.
///
/// Task i depends on the options and i alone, not on how many are drawn or in what order.
/// Thread-safe.
class TaskGenerator {
 public:
  /// @throws std::invalid_argument for a level outside 1 to 4, or `kUnseenTask` above level 2 of
  ///   another split than train.
  explicit TaskGenerator(const TaskOptions& options);

  const TaskOptions& options() const { return options_; }

  /// Task number i, with the id "level3-000017" for i = 17 at level 3. @pre i >= 0
  Task task(int i) const;

 private:
  TaskOptions options_;
};

/// The split to which an arrangement belongs: 80 % train, 10 % validation, 10 % test by a hash of
/// workbench, objects and goal. The same arrangement is never in two splits, whatever the seeds.
/// The combination of the target's concepts alone does not decide: the splits of `ConceptSet` are
/// what measures symbols of combinations not trained on. Appearances of tasks of two splits never
/// share a seed.
Split splitOf(const World& initial, const ObjectState& goal);

/// Whether the set of action types in a plan is held out from training under `kUnseenTask`: those
/// with both move_front and move_right, or both move_back and move_left. So training plans are
/// single directions, front with left, and back with right, and every move is trained on; above
/// level 2 with changes of colour and rotations among them, which do not count.
bool isHeldOut(const ActionSequence& plan);

}  // namespace conceptplan
