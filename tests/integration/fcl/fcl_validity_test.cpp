#include "conceptplan/fcl/fcl_validity.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <future>
#include <limits>
#include <random>
#include <stdexcept>

#include "conceptplan/domain/simulation/judgement.hpp"
#include "conceptplan/domain/simulation/task_generator.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "planners/learned_world.hpp"

namespace conceptplan {
namespace {

Symbols at(int x, int y, int size = 3, int type = 0) {
  return {SymbolId{type}, SymbolId{x}, SymbolId{y}, SymbolId{0}, SymbolId{0}, SymbolId{size}};
}

SymbolGrounding withRadius(double radius_m) {
  SymbolGrounding grounding = standardGrounding();
  grounding.footprints = uniformFootprints(kConceptCardinality, {outlineOfDisc(radius_m), 0.1});
  return grounding;
}

TEST(FclValidity, ObjectsInOneCellCollideWhateverTheirSizes) {
  const std::vector<Symbols> others{at(0, 0), at(1, 2, 0, 3)};
  for (int size = 0; size < 4; ++size) {
    const Verdict verdict = FclValidity().check({}, standardGrounding(), at(1, 2, size), others);
    EXPECT_EQ(verdict.cause, Invalidity::kCollision);
    EXPECT_EQ(verdict.object, 1u);
  }
}

TEST(FclValidity, NeighbouringCellsKeepTheClearanceBetweenTheirFootprints) {
  const std::vector<Symbols> others{at(1, 2)};
  const Verdict verdict = FclValidity().check({}, withRadius(0.06), at(0, 2), others);
  EXPECT_TRUE(verdict.valid());
  EXPECT_NEAR(verdict.clearance_m, 0.1 - 0.06, 1e-9);  // the edge is nearer than the object
}

TEST(FclValidity, TheClearanceOfNearObjectsIsTheirDistance) {
  const std::vector<Symbols> others{at(1, 3)};
  const Verdict verdict = FclValidity().check({}, withRadius(0.085), at(1, 2), others);
  EXPECT_TRUE(verdict.valid());
  EXPECT_NEAR(verdict.clearance_m, 0.2 - 2 * 0.085, 1e-9);
}

TEST(FclValidity, FootprintsCountUpToTheirShareOfACell) {
  const std::vector<Symbols> others{at(1, 3)};
  FclValidityOptions options;
  options.max_half_width_cells = 0.48;
  const Verdict verdict = FclValidity(options).check({}, withRadius(0.13), at(1, 2), others);
  EXPECT_TRUE(verdict.valid());
  EXPECT_NEAR(verdict.clearance_m, 2 * 0.2 * (0.5 - 0.48), 1e-9);
}

TEST(FclValidity, ObjectsCollideAsTheyAreTurned) {
  // A plank of 180 x 40 mm, its long side towards the other object or away from it.
  SymbolGrounding grounding = standardGrounding();
  for (const std::size_t rotation : {0u, 1u}) {
    Outline plank = outlineOfSquare(0.09);
    for (const std::size_t k : {4 * rotation, 4 * rotation + 8}) plank.support_m[k] = 0.02;
    grounding.footprints[0][3][rotation].outline = tightened(plank);
  }
  FclValidityOptions options;
  options.margin_m = 0.025;
  const std::vector<Symbols> others{at(1, 3, 3, 1)};
  Symbols turned = at(1, 2);
  EXPECT_NEAR(FclValidity(options).check({}, grounding, turned, others).clearance_m, 0.03, 1e-9);
  turned[index(Concept::kRotation)] = SymbolId{1};
  EXPECT_NEAR(FclValidity(options).check({}, grounding, turned, others).clearance_m, 0.1, 1e-9);
  options.margin_m = 0.05;
  EXPECT_TRUE(FclValidity(options).check({}, grounding, turned, others).valid());
  turned[index(Concept::kRotation)] = SymbolId{0};
  EXPECT_EQ(FclValidity(options).check({}, grounding, turned, others).cause,
            Invalidity::kCollision);
  // What turns on its way covers both.
  Symbols there = at(1, 2);
  there[index(Concept::kRotation)] = SymbolId{1};
  EXPECT_EQ(FclValidity(options).checkMotion({}, grounding, there, turned, others).cause,
            Invalidity::kCollision);
}

TEST(FclValidity, TheMarginMustRemain) {
  const std::vector<Symbols> others{at(1, 3)};
  FclValidityOptions options;
  options.margin_m = 0.05;
  const Verdict verdict = FclValidity(options).check({}, withRadius(0.085), at(1, 2), others);
  EXPECT_EQ(verdict.cause, Invalidity::kCollision);
  EXPECT_NEAR(verdict.clearance_m, 0.03, 1e-9);
}

TEST(FclValidity, BesideTheWorkbenchIsInvalid) {
  Workbench narrow;
  narrow.columns = 2;
  const Verdict verdict = FclValidity().check(narrow, withRadius(0.05), at(2, 0), {});
  EXPECT_EQ(verdict.cause, Invalidity::kWorkbenchEdge);
  EXPECT_NEAR(verdict.clearance_m, -0.1 - 0.05, 1e-9);
}

TEST(FclValidity, AFootprintWithoutMeasureIsANamedResult) {
  SymbolGrounding grounding = standardGrounding();
  grounding.footprints[0][3][0].height_m = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Symbols> others{at(1, 3, 3, 1)};
  EXPECT_EQ(FclValidity().check({}, grounding, at(1, 2), others).cause, Invalidity::kCheckFailed);
  const std::vector<Symbols> unmeasured{at(1, 3)};
  EXPECT_EQ(FclValidity().check({}, grounding, at(1, 2, 3, 1), unmeasured).cause,
            Invalidity::kCheckFailed);
}

TEST(FclValidity, AgreesWithTheGridOnObjectsThatFitTheirCells) {
  const SymbolGrounding grounding = standardGrounding();
  const std::vector<Symbols> others{at(0, 1, 3, 2), at(1, 3, 0, 7), at(2, 3, 2, 5)};
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 5; ++y) {
      for (int size = 0; size < 4; ++size) {
        const Symbols target = at(x, y, size);
        const Verdict fcl = FclValidity().check({}, grounding, target, others);
        const Verdict grid = GridValidity().check({}, grounding, target, others);
        EXPECT_EQ(fcl.cause, grid.cause);
        EXPECT_EQ(fcl.object, grid.object);
      }
    }
  }
}

TEST(FclValidity, FindsWhatTheDistanceOfOutlinesFindsOnFootprintsOfAllSizes) {
  std::mt19937_64 random(3);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  SymbolGrounding grounding = standardGrounding();
  FclValidityOptions options;
  options.margin_m = 0.03;
  options.max_half_width_cells = 0.499;
  const FclValidity validity(options);
  for (int i = 0; i < 20'000; ++i) {
    Footprint& own = grounding.footprints[0][0][0];
    Footprint& other = grounding.footprints[1][0][0];
    for (Footprint* footprint : {&own, &other}) {
      for (double& support_m : footprint->outline.support_m) support_m = draw(0.01, 0.0998);
      *footprint = {tightened(footprint->outline), draw(0.01, 0.3)};
    }
    const std::vector<Symbols> others{at(1, 2, 0, 1)};
    const Symbols target = at(i % 3, i / 3 % 5, 0, 0);
    const double clearance_m =
        conceptplan::clearance_m(prismOf({}, grounding, target, options.max_half_width_cells),
                                 prismOf({}, grounding, others[0], options.max_half_width_cells));
    if (std::abs(clearance_m - options.margin_m) < 1e-4) continue;  // FCL's own tolerance
    EXPECT_EQ(validity.check({}, grounding, target, others).valid(), clearance_m > options.margin_m)
        << i;
  }
}

TEST(FclValidity, AllStatesAtOnceAreAsEachAlone) {
  const SymbolGrounding grounding = standardGrounding();
  const std::vector<Symbols> others{at(0, 1, 3, 2), at(1, 3, 0, 7), at(2, 3, 2, 5)};
  std::vector<Symbols> targets;
  for (int i = 0; i < 60; ++i) targets.push_back(at(i % 3, i / 3 % 5, i / 15));
  const std::vector<Verdict> all = FclValidity().checkAll({}, grounding, targets, others);
  ASSERT_EQ(all.size(), targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    EXPECT_EQ(all[i], FclValidity().check({}, grounding, targets[i], others));
    EXPECT_EQ(all[i], FclValidity().StateValidity::checkAll({}, grounding, targets, others)[i]);
  }
}

TEST(FclValidity, AMotionMayHitWhatNeitherEndDoes) {
  const SymbolGrounding grounding = withRadius(0.08);
  const std::vector<Symbols> others{at(0, 0), at(1, 2)};
  const Verdict across = FclValidity().checkMotion({}, grounding, at(0, 2), at(2, 2), others);
  EXPECT_EQ(across.cause, Invalidity::kCollision);
  EXPECT_EQ(across.object, 1u);
  EXPECT_NEAR(across.clearance_m, -0.16, 1e-9);
  const Verdict diagonal = FclValidity().checkMotion({}, grounding, at(0, 2), at(1, 1), others);
  EXPECT_EQ(diagonal.cause, Invalidity::kCollision);  // 141 mm from the other's centre
  const Verdict beside = FclValidity().checkMotion({}, grounding, at(0, 2), at(0, 1), others);
  EXPECT_TRUE(beside.valid());
  EXPECT_NEAR(beside.clearance_m, 0.02, 1e-9);  // the edge
}

TEST(FclValidity, StepsFromCellToCellAreAsValidAsTheirEnds) {
  const SymbolGrounding grounding = standardGrounding();
  const std::vector<Symbols> others{at(0, 1), at(1, 3), at(2, 3)};
  for (int i = 0; i < 15; ++i) {
    const Symbols from = at(i % 3, i / 3);
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
      if (i % 3 + dx > 2 || i / 3 + dy > 4) continue;
      const Symbols to = at(i % 3 + dx, i / 3 + dy);
      const Verdict motion = FclValidity().checkMotion({}, grounding, from, to, others);
      const bool ends = FclValidity().check({}, grounding, from, others).valid() &&
                        FclValidity().check({}, grounding, to, others).valid();
      EXPECT_EQ(motion.valid(), ends);
    }
  }
}

TEST(FclValidity, ThreadsMayShareOne) {
  const FclValidity validity;
  const SymbolGrounding grounding = standardGrounding();
  const std::vector<Symbols> others{at(0, 1), at(1, 3)};
  const auto all = [&] {
    std::vector<double> clearances;
    for (int i = 0; i < 15; ++i) {
      clearances.push_back(validity.check({}, grounding, at(i % 3, i / 3), others).clearance_m);
    }
    return clearances;
  };
  const std::vector<double> alone = all();
  std::vector<std::future<std::vector<double>>> results;
  for (int i = 0; i < 4; ++i) results.push_back(std::async(std::launch::async, all));
  for (auto& result : results) EXPECT_EQ(result.get(), alone);
}

TEST(FclValidity, PlansOfBothPlannersSolveTasksOfEveryLevel) {
  const PlannerRegistry registry = PlannerRegistry::standard();
  for (const char* planner : {"belief", "bfs"}) {
    for (int level = 1; level <= 4; ++level) {
      TaskOptions options;
      options.level = level;
      options.split = Split::kTest;
      const TaskGenerator generator(options);
      for (int i = 0; i < 10; ++i) {
        const Task task = generator.task(i);
        const SymbolGraph graph = compile(
            testing::learnedModel(), testing::learnedRelabelling().problem(task), FclValidity());
        const PlanResult result = registry.make(planner)->solve(graph, {});
        ASSERT_EQ(result.status, PlanStatus::kSolved) << task.id;
        EXPECT_TRUE(judge(task, result.plans.front().actions).succeeded()) << task.id;
        EXPECT_EQ(result.statistics.validity_checks, 60u);  // each cell, turned each way
      }
    }
  }
}

TEST(FclValidity, RefusesOptionsOutOfRange) {
  EXPECT_THAT(
      [] {
        FclValidity validity({0, 0.48});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(::testing::HasSubstr("margin_m is 0")));
  EXPECT_THAT(
      [] {
        FclValidity validity({0.01, 0.5});
      },
      ::testing::ThrowsMessage<std::invalid_argument>(
          ::testing::HasSubstr("max_half_width_cells is 0.5")));
}

}  // namespace
}  // namespace conceptplan
