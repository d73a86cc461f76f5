#include "integration/nlopt/motion_worlds.hpp"

#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/collision.h>

#include <memory>
#include <stdexcept>

#include "conceptplan/domain/simulation/task_generator.hpp"
#include "conceptplan/fcl/fcl_validity.hpp"
#include "conceptplan/planners/bfs_planner.hpp"
#include "planners/learned_world.hpp"

namespace conceptplan::testing {
namespace {

/// `learnedModel` with footprints of the shipped model's sizes.
const SymbolicModel& measuredModel() {
  static const SymbolicModel model = [] {
    SymbolicModel measured = learnedModel();
    for (auto& type : measured.grounding.footprints) {
      for (Footprint& footprint : type) footprint.radius_m *= 0.085 / 0.08;
    }
    return measured;
  }();
  return model;
}

}  // namespace

MotionTask plannedMotion(int level, int number) {
  TaskOptions options;
  options.level = level;
  options.split = Split::kTest;
  const SymbolicProblem problem = learnedRelabelling().problem(TaskGenerator(options).task(number));
  const SymbolGraph graph = compile(measuredModel(), problem, FclValidity());
  PlanQuery query;
  query.top = 1;
  const PlanResult result = BfsPlanner().solve(graph, query);
  if (result.plans.empty()) throw std::runtime_error("no plan: " + result.reason);
  return motionTaskOf(problem, measuredModel().grounding, result.plans.front());
}

bool isClear(const MotionTask& task, const Trajectory& trajectory, double clearance_m) {
  const auto standing = [](const UprightCylinder& body, double x_m, double y_m, double lift_m,
                           double grown_m) {
    const double height_m = body.height_m + 2 * grown_m;
    return fcl::CollisionObjectd(
        std::make_shared<fcl::Cylinderd>(body.radius_m + grown_m, height_m),
        fcl::Matrix3d::Identity(), fcl::Vector3d(x_m, y_m, lift_m - grown_m + 0.5 * height_m));
  };
  const double half_x_m = 0.5 * task.workbench.columns * task.workbench.cell_m;
  const double half_y_m = 0.5 * task.workbench.rows * task.workbench.cell_m;
  for (const MotionPoint& point : trajectory.denseSamples(1e-3)) {
    const double room_m = task.target.radius_m + clearance_m;
    if (std::abs(point.x_m) + room_m > half_x_m + 1e-9) return false;
    if (std::abs(point.y_m) + room_m > half_y_m + 1e-9) return false;
    const auto target = standing(task.target, point.x_m, point.y_m, point.lift_m, clearance_m);
    for (const UprightCylinder& other : task.obstacles) {
      const auto obstacle = standing(other, other.p_WCentre.x(), other.p_WCentre.y(), 0, 0);
      fcl::CollisionResultd result;
      if (fcl::collide(&target, &obstacle, fcl::CollisionRequestd(1, false), result) > 0) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace conceptplan::testing
