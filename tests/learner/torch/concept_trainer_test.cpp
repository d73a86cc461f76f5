#include "conceptplan/learner/torch/concept_trainer.hpp"

#include <ATen/Parallel.h>
#include <gmock/gmock.h>

#include <sstream>

#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/learner/torch/encoder_batch.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "learner/random_crops.hpp"

namespace conceptplan {
namespace {

/// Blobs that differ in colour sample and size, as two concepts of two values.
ConceptImages twoConcepts() {
  ConceptImages images;
  for (std::uint8_t color = 0; color < 2; ++color)
    for (std::uint8_t size = 0; size < 2; ++size)
      images.add(encoderInput(coloredBlob(color, 10 + 8 * size)), {0, 0, 0, 0, color, size});
  return images;
}

ConceptTrainingOptions smallOptions() {
  ConceptTrainingOptions options;
  options.encoder_steps = 60;
  options.most_repairs = 0;
  options.sharpening_steps = 0;
  options.drawer_steps = 0;
  options.chains = 2;
  options.drawer_chains = 1;
  options.reconstructed_pairs = 2;
  options.reconstruction_start = 0.5;
  options.augmentation = kNoAugmentation;
  return options;
}

TEST(ConceptTrainer, Eq3FallsOnOneBatch) {
  const ConceptImages images = twoConcepts();
  ConceptTrainingOptions options = smallOptions();
  options.reconstruction_start = 0;
  options.use_weight = 0;  // four of the concepts have but one value here
  ConceptTrainer trainer(images, options);
  const auto total = [&](const ConceptLosses& losses) {
    return losses.disentangling + losses.pair + 10 * (losses.reconstruction + losses.direct);
  };
  const double before = total(trainer.step());
  double after = 0;
  while (trainer.stepsDone() < options.encoder_steps) after = total(trainer.step());
  EXPECT_LT(after, 0.4 * before);
}

/// What draws and locates from tokens is cut off, and nothing else asks for them: the one way to
/// the encoder is that from Z straight to the decoder.
TEST(ConceptTrainer, Eq3TheDirectBranchTeachesTheEncoderByItself) {
  const ConceptImages images = twoConcepts();
  ConceptTrainingOptions options = smallOptions();
  options.reconstruction_start = 0;
  options.disentangling_weight = options.pair_weight = options.use_weight = 0;
  ConceptTrainer trainer(images, options);
  NamedTensors before = tensorsOf(*trainer.averaged(), "concepts.");
  for (const char* cut : {"concepts.detokenizer.0.weight", "concepts.locator.0.weight"})
    for (float& weight : before.at(cut).values) weight = 0;
  trainer.startFrom(before, "");
  const ConceptLosses losses = trainer.step();
  EXPECT_GT(losses.direct, 0);
  EXPECT_GT(losses.reconstruction, 0);
  const NamedTensors after = tensorsOf(*trainer.averaged(), "concepts.");
  EXPECT_EQ(after.at("concepts.to_tokens.weight").values,
            before.at("concepts.to_tokens.weight").values);
  EXPECT_NE(after.at("concepts.encoder.0.weight").values,
            before.at("concepts.encoder.0.weight").values);
}

TEST(ConceptTrainer, TheDecoderJoinsWhenItShould) {
  const ConceptImages images = twoConcepts();
  ConceptTrainingOptions options = smallOptions();
  options.encoder_steps = 4;
  ConceptTrainer trainer(images, options);
  EXPECT_EQ(trainer.step().reconstruction, 0);
  EXPECT_EQ(trainer.step().reconstruction, 0);
  EXPECT_GT(trainer.step().reconstruction, 0);
}

TEST(ConceptTrainer, AResumedRunEndsAsAnUninterruptedOne) {
  const ConceptImages images = twoConcepts();
  ConceptTrainingOptions options = smallOptions();
  options.encoder_steps = options.sharpening_steps = options.drawer_steps = 2;
  options.repair_steps = 2;
  options.most_repairs = 1;
  ConceptTrainer whole(images, options);
  while (whole.stepsDone() < whole.stepsInAll()) whole.step();
  EXPECT_EQ(whole.stepsDone(), 10);
  const auto expected = tensorsOf(*whole.averaged(), "");

  for (const std::int64_t cut : {4, 5, 7, 9}) {  // before and in the repair, and in the third phase
    std::string checkpoint;
    {
      ConceptTrainer first(images, options);
      while (first.stepsDone() < cut) first.step();
      checkpoint = first.checkpoint();
    }
    ConceptTrainer second(images, options);
    second.restore(checkpoint);
    EXPECT_EQ(second.stepsDone(), cut);
    while (second.stepsDone() < second.stepsInAll()) second.step();
    EXPECT_EQ(second.stepsDone(), 10);
    const auto found = tensorsOf(*second.averaged(), "");
    for (const auto& [name, tensor] : expected)
      EXPECT_EQ(tensor.values, found.at(name).values) << name << " cut at " << cut;
  }
}

TEST(ConceptTrainer, TokensAreLearnedAgainOnlyWhereValuesShareAPrototype) {
  const ConceptImages images = twoConcepts();
  ConceptTrainingOptions options = smallOptions();
  options.use_weight = 0;  // four of the concepts have but one value here
  options.reconstruction_start = 1;
  options.averaging = 0;
  options.encoder_steps = 100;
  ConceptTrainer learning(images, options);
  while (learning.stepsDone() < learning.stepsInAll()) learning.step();
  const ConceptNetwork told = learning.averaged();

  options.learning_rate = 0;
  options.reconstruction_start = 0.5;
  options.encoder_steps = 4;
  options.repair_steps = 3;
  options.most_repairs = 2;
  options.sharpening_steps = 2;
  ConceptTrainer healthy(images, options);
  healthy.startFrom(tensorsOf(*told, "concepts."), "");
  while (healthy.stepsDone() < healthy.stepsInAll()) healthy.step();
  EXPECT_EQ(healthy.stepsDone(), 6);

  {
    const torch::NoGradGuard no_gradient;
    const auto& prototypes = told->prototypes(Concept::kColor);
    prototypes.copy_(prototypes[0].clone().expand_as(prototypes));
  }
  ConceptTrainer merged(images, options);
  merged.startFrom(tensorsOf(*told, "concepts."), "");
  std::vector<std::int64_t> steps_in_all;
  std::vector<bool> drawing;
  while (merged.stepsDone() < merged.stepsInAll()) {
    drawing.push_back(merged.step().reconstruction > 0);
    steps_in_all.push_back(merged.stepsInAll());
  }
  EXPECT_THAT(steps_in_all,
              testing::ElementsAre(6, 6, 6, 6, 6, 11, 11, 11, 11, 11, 16, 16, 16, 16, 16, 16));
  // The decoder joins in the second half of the first phase, each time.
  EXPECT_THAT(drawing, testing::ElementsAre(false, false, true, true, false, false,  //
                                            false, false, true, false, false,        //
                                            false, false, true, false, false));
}

/// The third phase alone.
ConceptTrainingOptions drawerOptions(std::int64_t steps) {
  ConceptTrainingOptions options = smallOptions();
  options.encoder_steps = 0;
  options.drawer_steps = steps;
  return options;
}

TEST(ConceptTrainer, KeepsAllElseWhileOnlyTheDrawerLearns) {
  const ConceptImages images = twoConcepts();
  ConceptTrainer trainer(images, drawerOptions(60));
  const auto before = tensorsOf(*trainer.averaged(), "");
  for (int i = 0; i < 3; ++i) trainer.step();
  const auto after = tensorsOf(*trainer.averaged(), "");
  std::size_t changed = 0;
  for (const auto& [name, tensor] : before) {
    const bool draws = name.starts_with("drawer") || name.starts_with("locator");
    if (draws) {
      changed += tensor.values != after.at(name).values ? 1 : 0;
    } else {
      EXPECT_EQ(tensor.values, after.at(name).values) << name;
    }
  }
  EXPECT_GT(changed, 5U);
}

TEST(ConceptTrainer, TheDrawerLearnsABatch) {
  const ConceptImages images = twoConcepts();
  ConceptTrainer trainer(images, drawerOptions(40));
  const double before = trainer.step().reconstruction;
  ConceptLosses losses;
  while (trainer.stepsDone() < trainer.stepsInAll()) {
    losses = trainer.step();
    EXPECT_EQ(losses.reading > 0, trainer.stepsDone() > 20) << trainer.stepsDone();
  }
  EXPECT_LT(losses.reconstruction, 0.5 * before);
}

TEST(ConceptTrainer, RefusesStepsOfADrawerForWholeFrames) {
  ConceptTrainingOptions options;
  options.encoder = EncoderKind::kFullFrame;
  options.drawer_steps = 7;
  EXPECT_THAT([&] { ConceptTrainer(twoConcepts(), options); },
              testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("take 7 steps")));
}

TEST(ConceptTrainer, PutsPrototypesThatNoPictureUsesBesideTheOneUsedMost) {
  const ConceptImages images = twoConcepts();
  ConceptTrainingOptions options = smallOptions();
  options.learning_rate = options.averaging = 0;
  options.revival_interval = 1;
  ConceptTrainer trainer(images, options);
  const ConceptNetwork network = trainer.averaged();
  const EncoderBatch batch = encoderBatch(std::vector{encoderInput(coloredBlob(0, 10))});
  torch::Tensor seen;  // the direction of the COLOR tokens
  {
    const torch::NoGradGuard no_gradient;
    const auto planes = encoderPlanes(batch.bytes, batch.location, EncoderKind::kObjectCentred);
    ConceptNetwork reader = network;
    const auto tokens = reader->tokenize(reader->encode(planes), batch.location);
    seen = tokens[0][static_cast<std::int64_t>(index(Concept::kColor))] / 8;
    network->prototypes(Concept::kColor)[0].copy_(seen);
    network->prototypes(Concept::kColor).slice(0, 1).copy_(-seen);
  }
  trainer.startFrom(tensorsOf(*network, "concepts."), "");
  trainer.step();
  EXPECT_LT(torch::matmul(trainer.averaged()->prototypes(Concept::kColor)[1], seen).item<double>(),
            -0.9);
  trainer.step();
  const auto revived =
      torch::nn::functional::normalize(trainer.averaged()->prototypes(Concept::kColor),
                                       torch::nn::functional::NormalizeFuncOptions().dim(1));
  EXPECT_GT(torch::matmul(revived, seen).min().item<double>(), 0.9);
}

/// The texts of all faults of restoring a checkpoint.
std::string faultsOfRestoring(ConceptTrainer& trainer, const std::string& checkpoint) {
  try {
    trainer.restore(checkpoint, "m/concepts.checkpoint");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ConceptTrainer, RefusesACheckpointOfAnotherSeedOtherOptionsOrImages) {
  using testing::HasSubstr;
  using testing::Not;
  const ConceptImages images = twoConcepts();
  ConceptTrainer trained(images, smallOptions());
  trained.step();
  const std::string checkpoint = trained.checkpoint();

  ConceptTrainer same(images, smallOptions());
  EXPECT_EQ(faultsOfRestoring(same, checkpoint), "");
  EXPECT_EQ(same.stepsDone(), 1);

  ConceptTrainingOptions options = smallOptions();
  options.seed = 5;
  ConceptTrainer reseeded(images, options);
  EXPECT_THAT(faultsOfRestoring(reseeded, checkpoint),
              testing::AllOf(HasSubstr("m/concepts.checkpoint: seed: this run has 5, the "
                                       "checkpoint is of 0; remove it to begin anew"),
                             Not(HasSubstr("images"))));
  EXPECT_EQ(reseeded.stepsDone(), 0);

  options = smallOptions();
  options.learning_rate = 0.25;
  options.augmentation.gain = 0.5;
  ConceptTrainer changed(images, options);
  EXPECT_THAT(
      faultsOfRestoring(changed, checkpoint),
      testing::AllOf(HasSubstr("learning_rate: this run has 0.25, the checkpoint is of "
                               "0.0015"),
                     HasSubstr("augmentation.gain: this run has 0.5"), Not(HasSubstr("seed"))));

  options = smallOptions();
  options.start_from = "01234567";
  ConceptTrainer begun(images, options);
  EXPECT_THAT(faultsOfRestoring(begun, checkpoint),
              HasSubstr("start_from: this run has 01234567, the checkpoint is of none; remove it"));

  ConceptImages more = twoConcepts();
  more.add(encoderInput(coloredBlob(3)), {0, 0, 0, 0, 2, 0});
  ConceptTrainer elsewhere(more, smallOptions());
  EXPECT_THAT(faultsOfRestoring(elsewhere, checkpoint), HasSubstr("images: this run has "));
}

TEST(ConceptTrainer, RefusesACheckpointOfAnotherNumberOfThreads) {
  const ConceptImages images = twoConcepts();
  const int threads = at::get_num_threads();
  at::set_num_threads(3);
  const std::string checkpoint = ConceptTrainer(images, smallOptions()).checkpoint();
  at::set_num_threads(2);
  ConceptTrainer trainer(images, smallOptions());
  at::set_num_threads(threads);
  EXPECT_THAT(faultsOfRestoring(trainer, checkpoint),
              testing::HasSubstr("m/concepts.checkpoint: threads: this run has 2, the checkpoint "
                                 "is of 3; go on with --jobs 3"));
}

TEST(ConceptTrainer, RefusesACheckpointThatDoesNotSayOfWhichRunItIs) {
  const ConceptImages images = twoConcepts();
  ConceptTrainer trainer(images, smallOptions());
  torch::serialize::OutputArchive archive;
  archive.write("steps_done", torch::tensor(std::int64_t{3}));
  std::ostringstream bytes;
  archive.save_to(bytes);
  EXPECT_THAT(faultsOfRestoring(trainer, bytes.str()),
              testing::HasSubstr("does not say of which seed, options and data it is"));
}

TEST(ConceptTrainer, LeavesTorchsDefaultGeneratorAsItWas) {
  torch::manual_seed(11);
  const auto expected = torch::rand({3});
  torch::manual_seed(11);
  const ConceptImages images = twoConcepts();
  ConceptTrainingOptions options = smallOptions();
  options.encoder_steps = 3;
  options.revival_interval = 1;
  ConceptTrainer trainer(images, options);
  for (int i = 0; i < 2; ++i) trainer.step();
  trainer.averaged();
  EXPECT_TRUE(torch::equal(torch::rand({3}), expected));
}

TEST(ConceptTrainer, RefusesACheckpointThatIsNone) {
  const ConceptImages images = twoConcepts();
  ConceptTrainer trainer(images, smallOptions());
  EXPECT_THROW(trainer.restore("not a checkpoint"), c10::Error);
}

TEST(ConceptTrainer, ThePapersTrainingIsItsNetworksLossesAndRatesAlone) {
  const ConceptTrainingOptions paper = paperConceptTraining();
  EXPECT_EQ(paper.encoder, EncoderKind::kFullFrame);
  EXPECT_EQ(paper.learning_rate, 3e-4);
  EXPECT_NEAR(paper.learning_rate * paper.tokenizer_rate_share, 1e-5, 1e-12);
  EXPECT_EQ(paper.pair_weight + paper.use_weight + paper.confidence_weight, 0);
  EXPECT_EQ(paper.sharpening_steps + paper.drawer_steps, 0);
  EXPECT_EQ(paper.disentangling_weight, 1);
  EXPECT_EQ(paper.reconstruction_weight, 1);
  EXPECT_EQ(paper.reconstruction_start, 0);
  EXPECT_EQ(paper.foreground_weight, 1);  // all pixels count alike
  EXPECT_EQ(paper.augmentation, kNoAugmentation);
}

TEST(ConceptTrainer, Eq3FallsOnOneBatchWithThePapersNetworksAndLossesAlone) {
  const ConceptImages images = twoConcepts();
  ConceptTrainingOptions options = paperConceptTraining();
  options.encoder_steps = 12;
  options.chains = 1;
  options.reconstructed_pairs = 2;
  ConceptTrainer trainer(images, options);
  const auto total = [](const ConceptLosses& losses) {
    return losses.disentangling + losses.reconstruction + losses.direct;
  };
  const double before = total(trainer.step());
  double after = 0;
  while (trainer.stepsDone() < options.encoder_steps) after = total(trainer.step());
  EXPECT_LT(after, 0.95 * before);  // slower than with the other profiles' five times higher rate
}

}  // namespace
}  // namespace conceptplan
