#include "conceptplan/domain/model/symbol_grounding.hpp"

#include <gmock/gmock.h>

namespace conceptplan {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(SymbolGrounding, TheStandardOneHasNoFaults) {
  EXPECT_THAT(standardGrounding().faults(kConceptCardinality), IsEmpty());
}

TEST(SymbolGrounding, TellsEveryFault) {
  SymbolGrounding grounding = standardGrounding();
  grounding.columns = {0, -1};
  grounding.footprints[3][1][2].height_m = 0;
  grounding.footprints[3][2][0].outline.support_m[5] = -1;
  grounding.footprints[4][0].pop_back();
  grounding.footprints[4][1][3].outline.support_m[1] += 0.01;
  grounding.footprints.pop_back();
  grounding.names[index(Concept::kSize)].resize(5);
  EXPECT_THAT(grounding.faults(kConceptCardinality),
              ElementsAre("columns: expected 3 entries, found 2",
                          "columns[1]: expected a cell index >= 0, found -1",
                          "footprints: expected 8 entries, found 7",
                          HasSubstr("footprints[3][1][2]: expected a height > 0 m"),
                          "footprints[3][2][0]: expected supports > 0 m",
                          "footprints[4][0]: expected 4 entries, found 3",
                          HasSubstr("footprints[4][1][3]: expected an outline that reaches"),
                          "names.SIZE: expected at most 4 names, found 5"));
}

TEST(SymbolGrounding, NamesSymbolsByNumberWhereTheyHaveNoName) {
  SymbolGrounding grounding = standardGrounding();
  EXPECT_EQ(grounding.name(Concept::kColor, SymbolId{4}), "blue");
  grounding.names[index(Concept::kColor)] = {"", "gold"};
  EXPECT_EQ(grounding.name(Concept::kColor, SymbolId{0}), "COLOR 0");
  EXPECT_EQ(grounding.name(Concept::kColor, SymbolId{1}), "gold");
  EXPECT_EQ(grounding.name(Concept::kColor, SymbolId{4}), "COLOR 4");
}

}  // namespace
}  // namespace conceptplan
