#include "conceptplan/learner/learned_symbols.hpp"

#include <gmock/gmock.h>

#include <numeric>

#include "conceptplan/domain/input_error.hpp"

namespace conceptplan {
namespace {

LearnedSymbols sample() {
  std::array<SymbolClusters, kNumConcepts> clusters;
  std::array<std::vector<int>, kNumConcepts> values;
  for (std::size_t k = 0; k < kNumConcepts; ++k) {
    const auto count = static_cast<Eigen::Index>(kConceptCardinality[k]);
    clusters[k].centers = TokenMatrix::Constant(count, 64, static_cast<float>(k));
    clusters[k].temperature = 0.5 + static_cast<double>(k);
    clusters[k].reach = 8 + static_cast<double>(k);
    values[k].resize(kConceptCardinality[k]);
    std::iota(values[k].rbegin(), values[k].rend(), 0);
  }
  SymbolGrounding grounding;
  grounding.columns = {2, 0, 1};
  grounding.rows = {4, 3, 2, 1, 0};
  grounding.footprints = uniformFootprints(kConceptCardinality, {outlineOfDisc(0.0625), 0.125});
  grounding.names = symbolNames(values);
  return {Symbolizer(clusters), grounding, values, {0.25, 0.0125, 0.5}};
}

TEST(LearnedSymbols, ReadsWhatItWrote) {
  const LearnedSymbols read = learnedSymbolsFrom(tensorsOf(sample()), "m");
  EXPECT_EQ(read.grounding, sample().grounding);
  EXPECT_EQ(read.values, sample().values);
  EXPECT_EQ(read.symbolizer.cardinality(), sample().symbolizer.cardinality());
  EXPECT_EQ(read.symbolizer.clusters(Concept::kSize).centers,
            sample().symbolizer.clusters(Concept::kSize).centers);
  EXPECT_DOUBLE_EQ(read.symbolizer.clusters(Concept::kColor).temperature, 4.5);
  EXPECT_DOUBLE_EQ(read.symbolizer.clusters(Concept::kSize).reach, 13);
  EXPECT_DOUBLE_EQ(read.most_residual.silhouette, 0.25);
  EXPECT_FLOAT_EQ(static_cast<float>(read.most_residual.depth_m), 0.0125F);
  EXPECT_DOUBLE_EQ(read.most_residual.color, 0.5);
}

TEST(LearnedSymbols, NamesSymbolsByTheirValues) {
  const auto names = sample().grounding.names;
  EXPECT_EQ(names[index(Concept::kType)].front(), "Dyer");
  EXPECT_EQ(names[index(Concept::kColor)].back(), "red");
  EXPECT_EQ(names[index(Concept::kRotation)].front(), "270 degrees");
}

TEST(LearnedSymbols, CollectsEveryFault) {
  NamedTensors tensors = tensorsOf(sample());
  tensors.erase("symbols.TYPE.centers");
  tensors["symbols.SIZE.temperature"].values = {-1};
  tensors["symbols.COLOR.reach"].values = {0};
  tensors["grounding.rows"].values[0] = -3;
  tensors["pictures.most_residual"].values[1] = 0;
  try {
    learnedSymbolsFrom(tensors, "m");
    FAIL() << "expected an InputError";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_THAT(text, testing::HasSubstr("symbols.TYPE.centers"));
    EXPECT_THAT(text, testing::HasSubstr("pictures.most_residual: expected three positive"));
    EXPECT_THAT(text, testing::HasSubstr("symbols.SIZE.temperature"));
    EXPECT_THAT(text, testing::HasSubstr("symbols.COLOR.reach"));
    EXPECT_THAT(text, testing::HasSubstr("grounding.rows"));
  }
}

}  // namespace
}  // namespace conceptplan
