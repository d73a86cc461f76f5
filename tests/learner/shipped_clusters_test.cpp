#include <gtest/gtest.h>

#include <string>

#include "conceptplan/learner/kmeans.hpp"
#include "conceptplan/pipeline/generation.hpp"
#include "conceptplan/pipeline/model.hpp"
#include "domain/files/temporary_folder.hpp"

namespace conceptplan {
namespace {

TEST(ShippedClusters, AreNotDoubted) {
  const TemporaryFolder folder;
  const Model model(CONCEPTPLAN_SHIPPED_MODEL);
  generateConcepts(folder.path(),
                   {.split = Split::kValidation, .samples = 1, .seed = model.manifest().seed}, {});
  const ConceptDataset data(folder.path());
  std::vector<EncoderInput> inputs;
  for (std::size_t i = 0; i < data.size(); i += 2)
    inputs.push_back(encoderInput(data.sample(i).crop));
  const std::vector<Tokens> tokens = model.learner().encode(inputs);
  for (const Concept which : kConcepts) {
    TokenMatrix points(static_cast<Eigen::Index>(tokens.size()), TokenMatrix::ColsAtCompileTime);
    for (std::size_t i = 0; i < tokens.size(); ++i)
      points.row(static_cast<Eigen::Index>(i)) =
          tokens[i].row(static_cast<Eigen::Index>(index(which)));
    const TokenMatrix& centers = model.symbols().symbolizer.clusters(which).centers;
    const ClusterLayout layout = clusterLayout(points, centers);
    EXPECT_EQ(doubts(layout), "") << name(which);
    EXPECT_GT(layout.least_separation, 6) << name(which);
  }
}

}  // namespace
}  // namespace conceptplan
