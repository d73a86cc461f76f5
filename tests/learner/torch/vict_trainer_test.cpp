#include "conceptplan/learner/torch/vict_trainer.hpp"

#include <ATen/Parallel.h>
#include <gmock/gmock.h>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/learner/torch/concept_network.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "conceptplan/learner/visual_transition.hpp"
#include "learner/square_frame.hpp"

namespace conceptplan {
namespace {

ConceptLearner freshLearner() {
  torch::manual_seed(3);
  return {tensorsOf(*ConceptNetwork(), "concepts."), EncoderKind::kObjectCentred, "m"};
}

SequenceFrame frame(int left, float token) {
  Tokens tokens = Tokens::Zero();
  tokens.col(0).setConstant(token);
  tokens.col(1).setConstant(8);
  return squareFrame(left, tokens);
}

std::vector<TaskSequence> sequences() {
  return {{{frame(100, 1), frame(140, 5)}, {Action::kMoveRight}, {Tokens::Zero()}},
          {{frame(140, 5), frame(100, 1)}, {Action::kMoveLeft}, {Tokens::Zero()}}};
}

VictTrainingOptions smallOptions() {
  VictTrainingOptions options;
  options.transition_steps = 40;
  options.transition_batch = 8;
  options.synthesis_steps = 40;
  options.synthesis_batch = 2;
  return options;
}

TEST(VictTrainer, Eq8TermsFallOnOneBatch) {
  const ConceptLearner learner = freshLearner();
  const auto data = sequences();
  VictTrainer trainer(data, learner, smallOptions());
  const double tokens_before = trainer.step().tokens;
  VictLosses losses;
  while (trainer.stepsDone() < 40) losses = trainer.step();
  EXPECT_LT(losses.tokens, 0.5 * tokens_before);
  // Each window shows a prediction or a reconstruction; means over five steps hold some of both.
  const auto meanOfFive = [&] {
    double sum = 0;
    for (int i = 0; i < 5; ++i) {
      losses = trainer.step();
      sum += losses.prediction + losses.reconstruction;
    }
    return sum / 5;
  };
  const double before = meanOfFive();
  while (trainer.stepsDone() < trainer.stepsInAll() - 5) trainer.step();
  EXPECT_LT(meanOfFive(), before);
}

TEST(VictTrainer, AResumedRunEndsAsAnUninterruptedOne) {
  const ConceptLearner learner = freshLearner();
  const auto data = sequences();
  VictTrainingOptions options = smallOptions();
  options.transition_steps = 3;
  options.synthesis_steps = 3;
  VictTrainer whole(data, learner, options);
  while (whole.stepsDone() < 6) whole.step();
  VictTrainer first(data, learner, options);
  while (first.stepsDone() < 4) first.step();
  VictTrainer second(data, learner, options);
  second.restore(first.checkpoint());
  while (second.stepsDone() < 6) second.step();
  const auto found = second.tensors();
  for (const auto& [name, tensor] : whole.tensors())
    EXPECT_EQ(tensor.values, found.at(name).values) << name;
}

TEST(VictTrainer, RefusesACheckpointOfAnotherRun) {
  using testing::HasSubstr;
  const ConceptLearner learner = freshLearner();
  auto data = sequences();
  VictTrainingOptions options = smallOptions();
  VictTrainer trained(data, learner, options);
  trained.step();
  const std::string checkpoint = trained.checkpoint();
  const auto expectFault = [&](const std::string& fault) {
    VictTrainer other(data, learner, options);
    EXPECT_THAT([&] { other.restore(checkpoint, "m/vict.checkpoint"); },
                testing::ThrowsMessage<InputError>(HasSubstr("m/vict.checkpoint: " + fault)));
    EXPECT_EQ(other.stepsDone(), 0);
  };
  options.seed = 9;
  expectFault("seed: this run has 9, the checkpoint is of 0; remove it to begin anew");
  options = smallOptions();
  options.synthesis_batch = 3;
  expectFault("synthesis_batch: this run has 3, the checkpoint is of 2");
  options = smallOptions();
  options.source = "a model";
  expectFault("source: this run has a model, the checkpoint is of ");
  options = smallOptions();
  data[1].frames[0].rgb[7] = 1;
  expectFault("pictures: this run has ");
  data = sequences();
  data[1].actions[0] = Action::kMoveFront;
  expectFault("pictures: this run has ");
  data = sequences();
  const int threads = at::get_num_threads();
  at::set_num_threads(threads + 1);
  expectFault("threads: this run has " + std::to_string(threads + 1) + ", the checkpoint is of " +
              std::to_string(threads) + "; go on with --jobs " + std::to_string(threads));
  at::set_num_threads(threads);
}

TEST(VictTrainer, LeavesTorchsDefaultGeneratorAsItWas) {
  const ConceptLearner learner = freshLearner();
  const auto data = sequences();
  torch::manual_seed(11);
  const auto expected = torch::rand({3});
  torch::manual_seed(11);
  VictTrainingOptions options = smallOptions();
  options.transition_steps = options.synthesis_steps = 1;
  VictTrainer trainer(data, learner, options);
  while (trainer.stepsDone() < 2) trainer.step();
  const VisualTransition loaded(trainer.tensors(), "m");
  EXPECT_TRUE(torch::equal(torch::rand({3}), expected));
}

/// The same weights, whatever was drawn before: those of the seed.
TEST(VictTrainer, DrawsTheWeightsOfItsSeed) {
  const ConceptLearner learner = freshLearner();
  const auto data = sequences();
  VictTrainingOptions options = smallOptions();
  options.seed = 4;
  torch::manual_seed(4);
  const CausalTransition transition;
  const FrameSynthesizer synthesizer;
  torch::manual_seed(77);
  const NamedTensors drawn = VictTrainer(data, learner, options).tensors();
  for (const auto& [name, tensor] : tensorsOf(*transition, "transition."))
    EXPECT_EQ(tensor.values, drawn.at(name).values) << name;
  for (const auto& [name, tensor] : tensorsOf(*synthesizer, "synthesizer."))
    EXPECT_EQ(tensor.values, drawn.at(name).values) << name;
}

TEST(VictTrainer, RefusesSequencesWithoutActions) {
  const ConceptLearner learner = freshLearner();
  const std::vector<TaskSequence> still{{{frame(100, 1)}, {}, {}}};
  EXPECT_THROW(VictTrainer(still, learner, smallOptions()), std::invalid_argument);
}

TEST(VisualTransition, Eq7KeepsTokenLengthAndSynthesizesOnlyNearTheObject) {
  const ConceptLearner learner = freshLearner();
  const auto data = sequences();
  const VictTrainer trainer(data, learner, smallOptions());
  const VisualTransition transition(trainer.tensors(), "m");
  const Tokens after =
      transition.apply(data[0].frames[0].tokens, Tokens::Zero(), Action::kMoveRight);
  for (Eigen::Index k = 0; k < 6; ++k) EXPECT_NEAR(after.row(k).norm(), 8, 1e-2);

  const RgbdImage image{kFrameWidth, kFrameHeight, data[0].frames[0].rgb,
                        std::vector<float>(kFrameWidth * kFrameHeight, 2.0F),
                        data[0].frames[0].hole};
  const Background background = backgroundWithout(image, 1);
  DrawnObject object = learner.draw({&after, 1}).front();
  object.location = {-0.2F, 0.0F, 0.0F};
  const RgbdImage next = transition.synthesize(background, 1, object);
  const auto& rgb = next.rgb;
  ASSERT_EQ(rgb.size(), image.rgb.size());
  EXPECT_EQ(rgb[0], 160);
  EXPECT_EQ(rgb[3 * (200 * kFrameWidth + 370)], 160);
  EXPECT_NE(rgb, background.image.rgb);
  EXPECT_THROW(transition.synthesize(background, 0, object), std::invalid_argument);
  EXPECT_THROW(transition.synthesize({}, 1, object), std::invalid_argument);
  EXPECT_THROW(transition.synthesize({image, background.hole}, 1, object), std::invalid_argument);
}

TEST(VisualTransition, DoesWithManyAsWithEachAlone) {
  const ConceptLearner learner = freshLearner();
  const auto data = sequences();
  const VictTrainer trainer(data, learner, smallOptions());
  const VisualTransition transition(trainer.tensors(), "m");
  std::vector<TransitionInput> steps;
  for (int i = 0; i < 20; ++i)
    steps.push_back({data[static_cast<std::size_t>(i % 2)].frames[0].tokens,
                     Tokens::Constant(0.1F * static_cast<float>(i)),
                     kActions[static_cast<std::size_t>(i) % kNumActions]});
  const std::vector<Tokens> after = transition.apply(steps);
  ASSERT_EQ(after.size(), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
    EXPECT_TRUE(
        after[i].isApprox(transition.apply(steps[i].tokens, steps[i].context, steps[i].action)));

  const SequenceFrame& first = data[0].frames[0];
  const RgbdImage image{kFrameWidth, kFrameHeight, first.rgb,
                        std::vector<float>(kFrameWidth * kFrameHeight, 2.0F), first.hole};
  const Background background = backgroundWithout(image, 1);
  std::vector<DrawnObject> objects = learner.draw(after);
  std::vector<SynthesisInput> inputs;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    objects[i].location = {-0.8F + 0.08F * static_cast<float>(i), 0.0F, 0.0F};
    inputs.push_back({background, static_cast<std::uint8_t>(1 + i), objects[i]});
  }
  const std::vector<RgbdImage> frames = transition.synthesize(inputs);  // in more than one pass
  ASSERT_EQ(frames.size(), inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const RgbdImage alone =
        transition.synthesize(background, static_cast<std::uint8_t>(1 + i), objects[i]);
    EXPECT_EQ(frames[i].rgb, alone.rgb) << i;
    EXPECT_EQ(frames[i].depth_m, alone.depth_m) << i;
    EXPECT_EQ(frames[i].mask, alone.mask) << i;
  }
  EXPECT_NE(frames[0].rgb, frames[1].rgb);
  EXPECT_TRUE(transition.apply(std::span<const TransitionInput>()).empty());
  EXPECT_TRUE(transition.synthesize({}).empty());
}

}  // namespace
}  // namespace conceptplan
