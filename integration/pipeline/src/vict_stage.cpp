#include <nlohmann/json.hpp>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/files/checksum.hpp"
#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/learner/background.hpp"
#include "conceptplan/learner/effect_context.hpp"
#include "conceptplan/learner/frame_composition.hpp"
#include "conceptplan/learner/learned_symbols.hpp"
#include "observed_frame.hpp"
#include "step_loop.hpp"

namespace conceptplan::training {
namespace {

/// What is known of a task's first picture: the target and the others, as tokens and symbols.
struct FirstFrame {
  std::vector<Symbols> others;
  std::vector<Tokens> other_tokens;
};

FirstFrame othersOf(const ObservedFrame& frame, std::size_t target, const Symbolizer& symbolizer) {
  FirstFrame others;
  for (std::size_t i = 0; i < frame.tokens.size(); ++i)
    if (i != target) {
      others.others.push_back(symbolizer.nearest(frame.tokens[i]));
      others.other_tokens.push_back(frame.tokens[i]);
    }
  return others;
}

SequenceFrame sequenceFrame(const RgbdImage& image, const ObservedFrame& observed,
                            std::size_t target) {
  const Eigen::Vector2d centre = pixelOf(observed.inputs[target].location);
  const std::uint8_t instance = observed.instances[target];
  Background background = backgroundWithout(image, instance);
  return {image.rgb,
          std::move(background.image.rgb),
          std::move(background.hole),
          objectsDepth_mm(background.image),
          centre.x(),
          centre.y(),
          observed.tokens[target]};
}

/// The pictures of a task up to where its target is hidden.
TaskSequence sequenceOf(const TaskDataset& data, const Task& task, const ConceptLearner& learner,
                        const Symbolizer& symbolizer, const SymbolicModel& model) {
  TaskSequence sequence;
  const auto target_id = static_cast<std::uint8_t>(task.initial.target + 1);
  FirstFrame others;
  for (std::size_t step = 0; step <= task.reference.size(); ++step) {
    const RgbdImage image = data.frame(task, static_cast<int>(step));
    const ObservedFrame observed = std::move(observeFrames(learner, {&image, 1}).front());
    const std::size_t target = observed.position(target_id);
    if (target == observed.instances.size()) break;
    if (step == 0) {
      others = othersOf(observed, target, symbolizer);
    } else {
      const Action action = task.reference[step - 1];
      const Tokens& before = sequence.frames.back().tokens;
      sequence.actions.push_back(action);
      sequence.contexts.push_back(effectContext(model, action, symbolizer.nearest(before),
                                                others.others, others.other_tokens));
    }
    sequence.frames.push_back(sequenceFrame(image, observed, target));
  }
  return sequence;
}

}  // namespace

std::vector<Work> victWork() {
  return {{"data: tasks-train", 4.4}, {"reading tasks-train", 3}, {"vict", 24}};
}

bool trainVict(const Run& run, ModelManifest& manifest) {
  const auto data = taskData(run);
  if (!data) return false;
  const auto concepts_path = run.options.model / kConceptsFile;
  const ConceptLearner learner(decodeTensors(readFile(concepts_path), concepts_path),
                               manifest.encoder, concepts_path);
  const auto symbols_path = run.options.model / kSymbolsFile;
  const LearnedSymbols symbols =
      learnedSymbolsFrom(decodeTensors(readFile(symbols_path), symbols_path), symbols_path);
  const SymbolicModel model = readSymbolicModel(run.options.model / kTransitionsFile);

  // Levels follow each other in the dataset; a stride takes tasks of all of them.
  std::size_t pictures = 0;
  for (const Task& task : data->tasks()) pictures += task.reference.size() + 1;
  const std::size_t stride =
      (pictures + run.profile.synthesis_frames - 1) / run.profile.synthesis_frames;
  std::vector<TaskSequence> sequences;
  for (std::size_t i = 0; i < data->tasks().size(); i += stride) {
    if (run.cancelled()) return false;
    run.report({"reading tasks-train", i, data->tasks().size(), ""});
    sequences.push_back(sequenceOf(*data, data->tasks()[i], learner, symbols.symbolizer, model));
  }

  VictTrainingOptions options = run.profile.vict;
  for (const auto& path : {concepts_path, symbols_path, run.options.model / kTransitionsFile})
    options.source += hexadecimal(crc32OfFile(path));
  VictTrainer trainer(sequences, learner, options);
  const auto describe = [](const VictLosses& losses) {
    return nlohmann::ordered_json{{"tokens", losses.tokens},
                                  {"prediction", losses.prediction},
                                  {"reconstruction", losses.reconstruction}}
        .dump();
  };
  constexpr double kTransitionStepCost = 0.3;  // perceptrons on tokens, against pictures
  const auto phases_of = [&] {
    return Phases{run.profile.vict.transition_steps, kTransitionStepCost};
  };
  if (!runSteps(run, TrainingStage::kTrainVict, trainer, phases_of, describe)) return false;
  writeFileAtomically(run.options.model / kVictFile,
                      encodeTensors(trainer.tensors(), TensorPrecision::kFloat16));
  return true;
}

}  // namespace conceptplan::training
