#include "conceptplan/learner/concept_learner.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <thread>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/learner/frame_window.hpp"
#include "conceptplan/learner/torch/concept_network.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "learner/random_crops.hpp"

namespace conceptplan {
namespace {

NamedTensors freshTensors(EncoderKind encoder) {
  torch::manual_seed(3);
  return tensorsOf(*ConceptNetwork(encoder), "concepts.");
}

TEST(ConceptLearner, SavedAndLoadedGivesTheSameTokens) {
  const NamedTensors tensors = freshTensors(EncoderKind::kObjectCentred);
  const std::vector<EncoderInput> inputs{encoderInput(coloredBlob(1)),
                                         encoderInput(coloredBlob(2))};
  const ConceptLearner learner(tensors, EncoderKind::kObjectCentred, "m");
  const ConceptLearner loaded(decodeTensors(encodeTensors(tensors, TensorPrecision::kFloat32), "m"),
                              EncoderKind::kObjectCentred, "m");
  EXPECT_EQ(learner.encode(inputs), loaded.encode(inputs));
}

TEST(ConceptLearner, TokensHaveFixedLengthAndDifferBetweenObjects) {
  for (const auto encoder : {EncoderKind::kObjectCentred, EncoderKind::kFullFrame}) {
    const ConceptLearner learner(freshTensors(encoder), encoder, "m");
    const std::vector<EncoderInput> inputs{encoderInput(coloredBlob(1)),
                                           encoderInput(coloredBlob(2))};
    const auto tokens = learner.encode(inputs);
    ASSERT_EQ(tokens.size(), 2U);
    for (Eigen::Index k = 0; k < 6; ++k) EXPECT_NEAR(tokens[0].row(k).norm(), 8, 1e-2);
    EXPECT_GT((tokens[0] - tokens[1]).norm(), 1e-3);
  }
}

TEST(ConceptLearner, DrawsPicturesInRange) {
  for (const auto encoder : {EncoderKind::kObjectCentred, EncoderKind::kFullFrame}) {
    const ConceptLearner learner(freshTensors(encoder), encoder, "m");
    const std::vector<EncoderInput> inputs{encoderInput(coloredBlob(1))};
    const auto drawn = learner.draw(learner.encode(inputs));
    ASSERT_EQ(drawn.size(), 1U);
    EXPECT_EQ(drawn[0].rgb.size(), 3U * 64 * 64);
    EXPECT_EQ(drawn[0].alpha.size(), 64U * 64);
    EXPECT_EQ(drawn[0].depth_m.size(), 64U * 64);
    EXPECT_THAT(drawn[0].rgb, testing::Each(testing::AllOf(testing::Ge(0.0F), testing::Le(1.0F))));
    EXPECT_TRUE(learner.draw({}).empty());
  }
}

TEST(ConceptLearner, EncodesAndDrawsManyAsEachAlone) {
  const ConceptLearner learner(freshTensors(EncoderKind::kObjectCentred),
                               EncoderKind::kObjectCentred, "m");
  std::vector<EncoderInput> inputs;
  for (std::uint64_t i = 0; i < 70; ++i)  // more than pass the network together
    inputs.push_back(encoderInput(coloredBlob(i)));
  const std::vector<Tokens> tokens = learner.encode(inputs);
  const std::vector<DrawnObject> drawn = learner.draw(tokens);
  ASSERT_EQ(tokens.size(), inputs.size());
  ASSERT_EQ(drawn.size(), inputs.size());
  for (std::size_t i = 0; i < inputs.size(); i += 23) {
    EXPECT_TRUE(learner.encode({&inputs[i], 1}).front().isApprox(tokens[i], 1e-4F));
    const DrawnObject alone = learner.draw({&tokens[i], 1}).front();
    EXPECT_THAT(alone.rgb, testing::Pointwise(testing::FloatNear(1e-4F), drawn[i].rgb)) << i;
    EXPECT_THAT(alone.alpha, testing::Pointwise(testing::FloatNear(1e-4F), drawn[i].alpha)) << i;
  }
}

TEST(ConceptLearner, LoadingLeavesTorchsDefaultGeneratorAsItWas) {
  const NamedTensors tensors = freshTensors(EncoderKind::kObjectCentred);
  torch::manual_seed(11);
  torch::randn({1});  // of a pair of normal numbers the second is kept
  const auto expected = torch::randn({3});
  torch::manual_seed(11);
  torch::randn({1});
  const ConceptLearner learner(tensors, EncoderKind::kObjectCentred, "m");
  EXPECT_TRUE(torch::equal(torch::randn({3}), expected));
}

TEST(ConceptLearner, ManyThreadsMayLoadAtOnce) {
  const NamedTensors tensors = freshTensors(EncoderKind::kObjectCentred);
  torch::manual_seed(11);
  const auto expected = torch::rand({3});
  torch::manual_seed(11);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] { ConceptLearner(tensors, EncoderKind::kObjectCentred, "m"); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(torch::equal(torch::rand({3}), expected));
}

TEST(ConceptLearner, NeverGivesNumbersThatAreNotFinite) {
  const std::vector<EncoderInput> inputs{encoderInput(coloredBlob(1))};
  for (const auto encoder : {EncoderKind::kObjectCentred, EncoderKind::kFullFrame}) {
    const NamedTensors good = freshTensors(encoder);
    const std::vector<Tokens> tokens = ConceptLearner(good, encoder, "m").encode(inputs);
    NamedTensors changed = good;
    for (float& weight : changed["concepts.encoder.0.weight"].values) weight = 3e38F;
    EXPECT_THAT([&] { ConceptLearner(changed, encoder, "m").encode(inputs); },
                testing::ThrowsMessage<InputError>(testing::HasSubstr(
                    "m: concepts: the weights give tokens that are not finite")));
    changed = good;
    for (float& weight : changed["concepts.locator.2.bias"].values) weight = -3e38F;
    const std::vector<DrawnObject> drawn = ConceptLearner(changed, encoder, "m").draw(tokens);
    EXPECT_THAT(drawn[0].location, testing::Each(-100.0F));
    EXPECT_EQ(cropCorner(drawn[0].location).left, -19040);
  }
}

TEST(ConceptLearner, RefusesWhatIsNotFinite) {
  const ConceptLearner learner(freshTensors(EncoderKind::kObjectCentred),
                               EncoderKind::kObjectCentred, "m");
  EncoderInput input = encoderInput(coloredBlob(1));
  input.location[2] = std::numeric_limits<float>::infinity();
  EXPECT_THAT(
      [&] {
        learner.encode({&input, 1});
      },
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("lies at inf")));
  const Tokens tokens = Tokens::Constant(std::numeric_limits<float>::quiet_NaN());
  EXPECT_THAT(
      [&] {
        learner.draw({&tokens, 1});
      },
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("tokens are not finite")));
}

TEST(ConceptLearner, NamesEveryTensorThatIsMissingOrMisshapen) {
  NamedTensors tensors = freshTensors(EncoderKind::kObjectCentred);
  tensors.erase("concepts.concept_queries");
  tensors["concepts.positions"] = {{2}, {0, 0}};
  try {
    ConceptLearner(tensors, EncoderKind::kObjectCentred, "concepts.safetensors");
    FAIL() << "expected an InputError";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("concepts.concept_queries: expected shape [6, 64], found none"));
    EXPECT_THAT(error.what(),
                testing::HasSubstr("concepts.positions: expected shape [64, 64], found [2]"));
  }
}

}  // namespace
}  // namespace conceptplan
