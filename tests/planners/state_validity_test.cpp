#include "conceptplan/planners/state_validity.hpp"

#include <gtest/gtest.h>

namespace conceptplan {
namespace {

Symbols at(int x, int y) {
  return {SymbolId{0}, SymbolId{x}, SymbolId{y}, SymbolId{0}, SymbolId{0}, SymbolId{0}};
}

TEST(GridValidity, CellsOfOtherObjectsAreTaken) {
  const std::vector<Symbols> others{at(0, 0), at(1, 2)};
  const GridValidity validity;
  const Verdict taken = validity.check({}, standardGrounding(), at(1, 2), others);
  EXPECT_EQ(taken.cause, Invalidity::kCollision);
  EXPECT_EQ(taken.object, 1u);
  EXPECT_TRUE(validity.check({}, standardGrounding(), at(2, 2), others).valid());
}

TEST(GridValidity, CellsBesideTheWorkbenchAreInvalid) {
  Workbench narrow;
  narrow.columns = 2;
  const Verdict verdict = GridValidity().check(narrow, standardGrounding(), at(2, 0), {});
  EXPECT_EQ(verdict.cause, Invalidity::kWorkbenchEdge);
}

TEST(Invalidity, HasNames) {
  EXPECT_EQ(name(Invalidity::kNone), "none");
  EXPECT_EQ(name(Invalidity::kCollision), "collision");
  EXPECT_EQ(name(Invalidity::kWorkbenchEdge), "workbench_edge");
  EXPECT_EQ(name(Invalidity::kCheckFailed), "check_failed");
}

}  // namespace
}  // namespace conceptplan
