#include "conceptplan/pipeline/concept_evaluation.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <set>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/pipeline/figures.hpp"
#include "conceptplan/pipeline/generation.hpp"

namespace conceptplan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The shipped model and one picture of each validation combination.
class ShippedConcepts : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::filesystem::temp_directory_path() /
              ("conceptplan-shipped-concepts-" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder_);
    model_ = std::make_unique<Model>(CONCEPTPLAN_SHIPPED_MODEL);
    generateConcepts(
        folder_, {.split = Split::kValidation, .samples = 1, .seed = model_->manifest().seed}, {});
    data_ = std::make_unique<ConceptDataset>(folder_);
  }
  static void TearDownTestSuite() {
    data_.reset();
    model_.reset();
    std::filesystem::remove_all(folder_);
  }

  static inline std::filesystem::path folder_;
  static inline std::unique_ptr<Model> model_;
  static inline std::unique_ptr<ConceptDataset> data_;
};

TEST_F(ShippedConcepts, AreReadRightAndApart) {
  const ConceptEvaluation result = evaluateConcepts(*data_, *model_);
  EXPECT_EQ(result.set, "validation/standard");
  EXPECT_EQ(result.pictures, 1152U);
  double least = 1;
  for (const Concept which : kConcepts) {
    EXPECT_GE(result.accuracy[index(which)], 0.985) << name(which);
    EXPECT_LT(result.calibration_error[index(which)], 0.02) << name(which);
    least = std::min(least, result.accuracy[index(which)]);
  }
  EXPECT_LE(result.all_right, least);
  EXPECT_GT(result.all_right, 0.98);
  EXPECT_LT(result.fit_no_symbol, 0.01);
  EXPECT_GT(result.disentanglement.dci.disentanglement, 0.9);
  EXPECT_GT(result.disentanglement.factor_vae, 0.95);
  EXPECT_EQ(result.disentanglement.dci.importance.rows(), 6);
}

TEST_F(ShippedConcepts, RefusesASetWhoseCombinationsTrainingMayHaveSeen) {
  const std::filesystem::path other = folder_.string() + "-other";
  generateConcepts(other, {.split = Split::kValidation, .samples = 1, .seed = 77}, {});
  const ConceptDataset data(other);
  EXPECT_THAT([&] { evaluateConcepts(data, *model_); },
              ::testing::ThrowsMessage<InputError>(HasSubstr("seed: expected 1, found 77")));
  EXPECT_THROW(drawFigures(*model_, data, {80, 5, {}}), InputError);
  std::filesystem::remove_all(other);
}

TEST_F(ShippedConcepts, ACancelledEvaluationHasNoPictures) {
  const std::atomic<bool> cancel{true};
  ConceptEvaluationOptions options;
  options.cancel = &cancel;
  EXPECT_EQ(evaluateConcepts(*data_, *model_, options).pictures, 0U);
}

TEST_F(ShippedConcepts, FiguresShowAllThatTheyPromise) {
  const std::vector<Figure> figures = drawFigures(*model_, *data_, {80, 5, {}});
  std::set<std::string> names;
  for (const Figure& figure : figures) {
    names.insert(figure.name);
    EXPECT_THAT(figure.svg, ::testing::StartsWith("<svg "));
    EXPECT_THAT(figure.svg, ::testing::EndsWith("</svg>\n"));
    EXPECT_THAT(figure.svg, Not(HasSubstr("not a number")));
  }
  EXPECT_THAT(names, ::testing::ElementsAre("clusters", "displacements", "substitution-grid",
                                            "token-changes"));
  for (const Concept which : kConcepts)
    for (const std::size_t figure : {0, 1, 3})
      EXPECT_THAT(figures[figure].svg, HasSubstr(">" + std::string(name(which)) + "<"));
  EXPECT_THAT(figures[2].svg, HasSubstr(">change color<"));
  const std::vector<Figure> again = drawFigures(*model_, *data_, {80, 5, {}});
  for (std::size_t i = 0; i < figures.size(); ++i) EXPECT_EQ(figures[i].svg, again[i].svg);
}

TEST_F(ShippedConcepts, OnePictureIsTooFewForAFigure) {
  EXPECT_THROW(drawFigures(*model_, *data_, {1, 5, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace conceptplan
