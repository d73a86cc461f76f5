#include "integration/nlopt/motion_worlds.hpp"

#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/collision.h>

#include <array>
#include <memory>
#include <stdexcept>

#include "conceptplan/domain/simulation/task_generator.hpp"
#include "conceptplan/fcl/fcl_validity.hpp"
#include "conceptplan/planners/bfs_planner.hpp"
#include "planners/learned_world.hpp"

namespace conceptplan::testing {
namespace {

/// `learnedModel` with footprints of the shipped model's sizes: discs, squares and planks that are
/// turned as they are.
const SymbolicModel& measuredModel() {
  static const SymbolicModel model = [] {
    SymbolicModel measured = learnedModel();
    for (std::size_t type = 0; type < measured.grounding.footprints.size(); ++type) {
      for (auto& of_size : measured.grounding.footprints[type]) {
        for (std::size_t rotation = 0; rotation < of_size.size(); ++rotation) {
          const double half_m = of_size[rotation].outline.support_m[0] * 0.085 / 0.08;
          Outline outline = type % 3 == 0 ? outlineOfDisc(half_m) : outlineOfSquare(half_m);
          if (type % 3 == 2) {
            for (const std::size_t k : rotation % 2 == 0 ? std::array{4u, 12u} : std::array{0u, 8u})
              outline.support_m[k] = 0.5 * half_m;
          }
          of_size[rotation].outline = tightened(outline);
        }
      }
    }
    return measured;
  }();
  return model;
}

/// The prism, lifted and grown to all sides, as one convex body of FCL.
fcl::CollisionObjectd standing(const UprightPrism& prism, double lift_m, double grown_m) {
  Outline outline = prism.outline;
  for (double& support_m : outline.support_m) support_m += grown_m;
  const std::vector<Eigen::Vector2d> base = cornersOf(outline);
  const auto count = static_cast<int>(base.size());
  auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
  auto faces = std::make_shared<std::vector<int>>();
  for (const Eigen::Vector2d& corner : base) {
    const Eigen::Vector2d p_W = prism.p_WCentre + corner;
    vertices->emplace_back(p_W.x(), p_W.y(), lift_m - grown_m);
    vertices->emplace_back(p_W.x(), p_W.y(), lift_m + prism.height_m + grown_m);
  }
  for (const int top : {0, 1}) {
    faces->push_back(count);
    for (int i = 0; i < count; ++i) faces->push_back(2 * (top == 1 ? i : count - 1 - i) + top);
  }
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    faces->insert(faces->end(), {4, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
  }
  return fcl::CollisionObjectd(std::make_shared<fcl::Convexd>(vertices, count + 2, faces));
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
  const double half_x_m = 0.5 * task.workbench.columns * task.workbench.cell_m;
  const double half_y_m = 0.5 * task.workbench.rows * task.workbench.cell_m;
  std::vector<fcl::CollisionObjectd> obstacles;
  for (const UprightPrism& other : task.obstacles) obstacles.push_back(standing(other, 0, 0));
  for (const MotionPoint& point : trajectory.denseSamples(1e-3)) {
    const UprightPrism target =
        task.target(waypointAfter(task, trajectory, point.time_s), {point.x_m, point.y_m});
    for (const Eigen::Vector2d& corner : cornersOf(target.outline)) {
      const Eigen::Vector2d p_W = target.p_WCentre + corner;
      if (std::abs(p_W.x()) + clearance_m > half_x_m + 1e-9) return false;
      if (std::abs(p_W.y()) + clearance_m > half_y_m + 1e-9) return false;
    }
    const fcl::CollisionObjectd body = standing(target, point.lift_m, clearance_m);
    for (const fcl::CollisionObjectd& obstacle : obstacles) {
      fcl::CollisionResultd result;
      if (fcl::collide(&body, &obstacle, fcl::CollisionRequestd(1, false), result) > 0) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace conceptplan::testing
