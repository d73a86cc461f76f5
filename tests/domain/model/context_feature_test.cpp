#include "conceptplan/domain/model/context_feature.hpp"

#include <gmock/gmock.h>

namespace conceptplan {
namespace {

const ConceptCardinality kCardinality = kConceptCardinality;

Symbols at(int type, int x, int y, int color = 0) {
  return {SymbolId{type}, SymbolId{x}, SymbolId{y}, SymbolId{0}, SymbolId{color}, SymbolId{0}};
}

constexpr ContextFeature kOffsetTo7{ContextKind::kNearestOffset, Concept::kType, SymbolId{7}};
constexpr ContextFeature kColorOf7{ContextKind::kNearestSymbol, Concept::kColor, SymbolId{7}};
constexpr ContextFeature kOwnRow{ContextKind::kOwnSymbol, Concept::kPositionY, SymbolId{0}};

TEST(ContextFeature, ReadsTheTargetsOwnSymbol) {
  const SymbolGrounding grounding = standardGrounding();
  EXPECT_EQ(valueOf(kOwnRow, kCardinality, {grounding, at(0, 1, 4), {}}), 4u);
  EXPECT_EQ(valueCount(kOwnRow, kCardinality), 5u);
}

TEST(ContextFeature, OffsetsCountRowsThenColumnsFromMinusTwo) {
  const SymbolGrounding grounding = standardGrounding();
  const std::vector<Symbols> others{at(7, 2, 2)};
  const auto from = [&](int x, int y) {
    return valueOf(kOffsetTo7, kCardinality, {grounding, at(0, x, y), others});
  };
  EXPECT_EQ(from(2, 2), 12u);  // (0, 0)
  EXPECT_EQ(from(1, 2), 13u);  // (1, 0)
  EXPECT_EQ(from(2, 1), 17u);  // (0, 1)
  EXPECT_EQ(from(0, 0), 24u);  // (2, 2)
  EXPECT_EQ(from(2, 4), 2u);   // (0, -2)
}

TEST(ContextFeature, OffsetsAreClippedToTwoCells) {
  const SymbolGrounding grounding = standardGrounding();
  const std::vector<Symbols> others{at(7, 1, 4)};
  EXPECT_EQ(valueOf(kOffsetTo7, kCardinality, {grounding, at(0, 1, 0), others}),
            valueOf(kOffsetTo7, kCardinality, {grounding, at(0, 1, 2), others}));
}

TEST(ContextFeature, AnAbsentObjectGivesTheLastValue) {
  const SymbolGrounding grounding = standardGrounding();
  const std::vector<Symbols> others{at(3, 0, 0)};
  const Surroundings surroundings{grounding, at(0, 1, 1), others};
  EXPECT_EQ(valueOf(kOffsetTo7, kCardinality, surroundings), 25u);
  EXPECT_EQ(valueOf(kColorOf7, kCardinality, surroundings), 6u);
  EXPECT_TRUE(isAbsent(kColorOf7, kCardinality, 6));
  EXPECT_FALSE(isAbsent(kColorOf7, kCardinality, 5));
  EXPECT_FALSE(isAbsent(kOwnRow, kCardinality, 4));
}

TEST(ContextFeature, TheNearestObjectCountsAndTiesGoToTheNearerRow) {
  const SymbolGrounding grounding = standardGrounding();
  const std::vector<Symbols> others{at(7, 1, 4, 1), at(7, 1, 1, 2), at(7, 0, 2, 3)};
  EXPECT_EQ(valueOf(kColorOf7, kCardinality, {grounding, at(0, 1, 2), others}), 2u);
  EXPECT_EQ(valueOf(kColorOf7, kCardinality, {grounding, at(0, 1, 3), others}), 1u);
}

TEST(ContextFeature, PositionsAreReadThroughTheGrounding) {
  SymbolGrounding grounding = standardGrounding();
  grounding.columns = {2, 1, 0};
  const std::vector<Symbols> others{at(7, 0, 0)};  // column 2
  EXPECT_EQ(valueOf(kOffsetTo7, kCardinality, {grounding, at(0, 1, 0), others}), 13u);
}

TEST(ContextFeature, JointValuesSplitBackIntoTheirParts) {
  const SymbolGrounding grounding = standardGrounding();
  const std::vector<ContextFeature> features{kOwnRow, kColorOf7, kOffsetTo7};
  const std::vector<Symbols> others{at(7, 2, 2, 5)};
  const Surroundings surroundings{grounding, at(0, 1, 3), others};
  const std::size_t joint = jointValueOf(features, kCardinality, surroundings);
  std::vector<std::size_t> parts;
  for (const ContextFeature& feature : features) {
    parts.push_back(valueOf(feature, kCardinality, surroundings));
  }
  EXPECT_EQ(splitJointValue(features, kCardinality, joint), parts);
  EXPECT_EQ(jointValueOf({}, kCardinality, surroundings), 0u);
}

TEST(ContextFeature, IsDescribedInTheWordsOfTheGrounding) {
  const SymbolGrounding grounding = standardGrounding();
  EXPECT_EQ(describe(kOwnRow, grounding), "own POSITION_Y");
  EXPECT_EQ(describe(kColorOf7, grounding), "COLOR of the nearest Dyer");
  EXPECT_EQ(describe(kOffsetTo7, grounding), "offset to the nearest Dyer");
}

}  // namespace
}  // namespace conceptplan
