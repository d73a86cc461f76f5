#include "conceptplan/learner/torch/vict_trainer.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "conceptplan/domain/files/checksum.hpp"
#include "conceptplan/learner/frame_composition.hpp"
#include "conceptplan/learner/frame_window.hpp"
#include "conceptplan/learner/torch/generator_guard.hpp"
#include "conceptplan/learner/torch/module_tensors.hpp"
#include "conceptplan/learner/torch/token_tensors.hpp"
#include "conceptplan/learner/torch/training_state.hpp"

namespace conceptplan {
namespace {

constexpr std::int64_t kEdge = FrameWindow::kEdge;
constexpr int kCenterJitter_px = 10;

/// A step of a sequence that has one.
std::pair<const TaskSequence*, std::size_t> drawStep(const std::vector<TaskSequence>& sequences,
                                                     std::mt19937_64& generator) {
  while (true) {
    const TaskSequence& sequence = sequences[generator() % sequences.size()];
    if (!sequence.actions.empty()) return {&sequence, generator() % sequence.actions.size()};
  }
}

/// One window to draw: the frame it starts from, the tokens to draw, and the frame it should be.
struct WindowExample {
  const SequenceFrame* source;
  const SequenceFrame* destination;
  Tokens tokens;
  bool reconstruction;
};

torch::Tensor actionTensor(const std::vector<Action>& actions) {
  std::vector<std::int64_t> numbers;
  for (const Action action : actions) numbers.push_back(static_cast<std::int64_t>(index(action)));
  return torch::tensor(numbers);
}

/// A checksum of all pictures and actions. Tokens are left out: they follow from these, the source
/// and the number of threads.
std::uint32_t checksum(const std::vector<TaskSequence>& sequences) {
  std::string parts;
  for (const TaskSequence& sequence : sequences) {
    for (const SequenceFrame& frame : sequence.frames)
      parts +=
          hexadecimal(crc32({reinterpret_cast<const char*>(frame.rgb.data()), frame.rgb.size()}));
    for (const Action action : sequence.actions) parts += ' ' + std::to_string(index(action));
    parts += '\n';
  }
  return crc32(parts);
}

/// Which run a checkpoint is of: every option and what is learned from.
CheckpointIdentity identityOf(const std::vector<TaskSequence>& sequences,
                              const VictTrainingOptions& options) {
  CheckpointIdentity identity;
  identity.add("stage", std::string("vict"));
  identity.add("seed", options.seed);
  identity.add("pictures", hexadecimal(checksum(sequences)));
  identity.add("source", options.source);
  identity.add("transition_steps", options.transition_steps);
  identity.add("transition_batch", options.transition_batch);
  identity.add("synthesis_steps", options.synthesis_steps);
  identity.add("synthesis_batch", options.synthesis_batch);
  identity.add("learning_rate", options.learning_rate);
  identity.add("averaging", options.averaging);
  return identity;
}

}  // namespace

VictTrainer::VictTrainer(const std::vector<TaskSequence>& sequences, const ConceptLearner& learner,
                         const VictTrainingOptions& options)
    : VictTrainer(sequences, learner, options, GeneratorGuard(options.seed)) {}

VictTrainer::VictTrainer(const std::vector<TaskSequence>& sequences, const ConceptLearner& learner,
                         const VictTrainingOptions& options, const GeneratorGuard&)
    : sequences_(sequences),
      learner_(learner),
      options_(options),
      identity_(identityOf(sequences, options)),
      transition_optimizer_(transition_->parameters(),
                            torch::optim::AdamWOptions(options.learning_rate).weight_decay(1e-4)),
      synthesis_optimizer_(synthesizer_->parameters(),
                           torch::optim::AdamWOptions(options.learning_rate).weight_decay(1e-5)) {
  if (std::none_of(sequences.begin(), sequences.end(),
                   [](const auto& sequence) { return !sequence.actions.empty(); }))
    throw std::invalid_argument("VictTrainer: no sequence has an action");
  copyParameters(*average_, *synthesizer_);
}

VictLosses VictTrainer::step() {
  auto generator = stepGenerator(options_.seed, steps_done_);
  const VictLosses losses = steps_done_ < options_.transition_steps ? transitionStep(generator)
                                                                    : synthesisStep(generator);
  ++steps_done_;
  return losses;
}

VictLosses VictTrainer::transitionStep(std::mt19937_64& generator) {
  std::vector<Tokens> before, context, after;
  std::vector<Action> actions;
  for (std::int64_t i = 0; i < options_.transition_batch; ++i) {
    const auto [sequence, at] = drawStep(sequences_, generator);
    before.push_back(sequence->frames[at].tokens);
    after.push_back(sequence->frames[at + 1].tokens);
    context.push_back(sequence->contexts[at]);
    actions.push_back(sequence->actions[at]);
  }
  setLearningRate(transition_optimizer_, static_cast<double>(steps_done_) /
                                             static_cast<double>(options_.transition_steps));
  transition_optimizer_.zero_grad();
  const auto predicted =
      transition_->forward(toTensor(before), toTensor(context), actionTensor(actions));
  const auto loss = tokenLoss(predicted, toTensor(after));
  loss.backward();
  transition_optimizer_.step();
  return {loss.item<double>(), 0, 0};
}

VictLosses VictTrainer::synthesisStep(std::mt19937_64& generator) {
  // Half of the windows show the next frame with the object as T predicts it, a quarter the frame
  // itself, a quarter another frame of the task, as a plan's later steps are drawn.
  std::vector<WindowExample> examples;
  for (std::int64_t i = 0; i < options_.synthesis_batch; ++i) {
    const auto [sequence, at] = drawStep(sequences_, generator);
    const SequenceFrame& source = sequence->frames[at];
    const auto kind = generator() % 4;
    if (kind < 2) {
      const torch::NoGradGuard no_gradient;
      const auto next = transition_->forward(toTensor({&source.tokens, 1}),
                                             toTensor({&sequence->contexts[at], 1}),
                                             actionTensor({sequence->actions[at]}));
      examples.push_back({&source, &sequence->frames[at + 1], toTokens(next).front(), false});
    } else {
      const SequenceFrame& shown =
          kind == 2 ? source : sequence->frames[generator() % sequence->frames.size()];
      examples.push_back({&source, &shown, shown.tokens, &shown == &source});
    }
  }
  std::vector<Tokens> tokens;
  for (const WindowExample& example : examples) tokens.push_back(example.tokens);
  std::vector<DrawnObject> drawn = learner_.draw(tokens);

  auto planes = torch::empty({options_.synthesis_batch, 8, kEdge, kEdge});
  auto truth = torch::empty({options_.synthesis_batch, 3, kEdge, kEdge});
  auto reconstruction = torch::empty({options_.synthesis_batch, 1, 1, 1});
  for (std::int64_t i = 0; i < options_.synthesis_batch; ++i) {
    const WindowExample& example = examples[static_cast<std::size_t>(i)];
    const SequenceFrame& centered = generator() % 2 == 0 ? *example.source : *example.destination;
    const auto jitter = [&] {
      return static_cast<double>(generator() % (2 * kCenterJitter_px + 1)) - kCenterJitter_px;
    };
    const double x = centered.x_px + jitter(), y = centered.y_px + jitter();
    const WindowCorner corner = windowAround(x, y, kFrameWidth, kFrameHeight);
    const FrameWindow window =
        cutWindow(example.source->floor_rgb, example.source->hole, kFrameWidth, corner,
                  hiddenBehind(std::move(drawn[static_cast<std::size_t>(i)]),
                               example.source->others_mm, kFrameWidth));
    planes[i].copy_(torch::tensor(window.planes).view({8, kEdge, kEdge}));
    const auto frame = torch::from_blob(const_cast<std::uint8_t*>(example.destination->rgb.data()),
                                        {kFrameHeight, kFrameWidth, 3}, torch::kUInt8);
    truth[i].copy_(frame.slice(0, corner.top, corner.top + kEdge)
                       .slice(1, corner.left, corner.left + kEdge)
                       .permute({2, 0, 1}));
    reconstruction[i].fill_(example.reconstruction ? 1.0 : 0.0);
  }
  truth /= 255.0;

  setLearningRate(synthesis_optimizer_,
                  static_cast<double>(steps_done_ - options_.transition_steps) /
                      static_cast<double>(options_.synthesis_steps));
  synthesis_optimizer_.zero_grad();
  const auto frames = synthesizer_->forward(planes.slice(1, 0, 3), planes.slice(1, 3, 4),
                                            planes.slice(1, 4, 7), planes.slice(1, 7, 8));
  synthesisLoss(frames, truth).backward();
  torch::nn::utils::clip_grad_norm_(synthesizer_->parameters(), 1.0);
  synthesis_optimizer_.step();
  updateAverage(*average_, *synthesizer_, options_.averaging,
                steps_done_ - options_.transition_steps);
  return synthesisErrors(frames, truth, reconstruction);
}

void VictTrainer::setLearningRate(torch::optim::AdamW& optimizer, double progress) const {
  for (auto& group : optimizer.param_groups())
    static_cast<torch::optim::AdamWOptions&>(group.options())
        .lr(options_.learning_rate * learningRateShare(progress, 0.02));
}

NamedTensors VictTrainer::tensors() const {
  NamedTensors tensors = tensorsOf(*transition_, "transition.");
  tensors.merge(tensorsOf(*average_, "synthesizer."));
  return tensors;
}

std::string VictTrainer::checkpoint() const {
  torch::serialize::OutputArchive archive, transition, synthesizer, average, first, second;
  transition_->save(transition);
  synthesizer_->save(synthesizer);
  average_->save(average);
  transition_optimizer_.save(first);
  synthesis_optimizer_.save(second);
  identity_.write(archive);
  archive.write("transition", transition);
  archive.write("synthesizer", synthesizer);
  archive.write("average", average);
  archive.write("transition_optimizer", first);
  archive.write("synthesis_optimizer", second);
  archive.write("steps_done", torch::tensor(steps_done_));
  std::ostringstream bytes;
  archive.save_to(bytes);
  return bytes.str();
}

void VictTrainer::restore(const std::string& checkpoint, const std::filesystem::path& path) {
  torch::serialize::InputArchive archive, transition, synthesizer, average, first, second;
  std::istringstream bytes(checkpoint);
  archive.load_from(bytes);
  identity_.check(archive, path);
  archive.read("transition", transition);
  archive.read("synthesizer", synthesizer);
  archive.read("average", average);
  archive.read("transition_optimizer", first);
  archive.read("synthesis_optimizer", second);
  torch::Tensor steps_done;
  archive.read("steps_done", steps_done);
  transition_->load(transition);
  synthesizer_->load(synthesizer);
  average_->load(average);
  transition_optimizer_.load(first);
  synthesis_optimizer_.load(second);
  steps_done_ = steps_done.item<std::int64_t>();
}

}  // namespace conceptplan
