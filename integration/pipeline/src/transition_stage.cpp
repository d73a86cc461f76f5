#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/learner/learned_symbols.hpp"
#include "conceptplan/learner/transitions/transition_estimation.hpp"
#include "observed_frame.hpp"
#include "training_stages.hpp"

namespace conceptplan::training {

std::vector<Work> transitionWork() { return {{"data: tasks-train", 4.4}, {"transitions", 2}}; }

bool countTransitions(const Run& run, ModelManifest& manifest) {
  const auto data = taskData(run);
  if (!data) return false;
  const auto concepts_path = run.options.model / kConceptsFile;
  const ConceptLearner learner(decodeTensors(readFile(concepts_path), concepts_path),
                               manifest.encoder, concepts_path);
  const auto symbols_path = run.options.model / kSymbolsFile;
  const LearnedSymbols symbols =
      learnedSymbolsFrom(decodeTensors(readFile(symbols_path), symbols_path), symbols_path);

  std::vector<Triplet> triplets;
  for (std::size_t i = 0; i < data->tasks().size(); ++i) {
    if (run.cancelled()) return false;
    run.report({"transitions", i, data->tasks().size(), ""});
    const Task& task = data->tasks()[i];
    std::vector<RgbdImage> pictures;
    for (std::size_t step = 0; step <= task.reference.size(); ++step)
      pictures.push_back(data->frame(task, static_cast<int>(step)));
    const std::vector<ObservedFrame> frames = observeFrames(learner, pictures);
    // The other objects stand still: the first picture tells of them, each later one of the target.
    const ObservedFrame& first = frames.front();
    const auto target_id = static_cast<std::uint8_t>(task.initial.target + 1);
    const std::size_t target = first.position(target_id);
    if (target == first.instances.size()) continue;  // wholly hidden
    Triplet triplet;
    triplet.target = target;
    for (const Tokens& tokens : first.tokens)
      triplet.objects.push_back(symbols.symbolizer.nearest(tokens));
    for (std::size_t step = 0; step < task.reference.size(); ++step) {
      const ObservedFrame& next = frames[step + 1];
      const std::size_t at = next.position(target_id);
      if (at == next.instances.size()) break;
      triplet.action = task.reference[step];
      triplet.after = symbols.symbolizer.nearest(next.tokens[at]);
      triplets.push_back(triplet);
      triplet.objects[target] = triplet.after;
    }
  }
  const SymbolicModel model =
      estimateSymbolicModel(triplets, symbols.grounding, symbols.symbolizer.cardinality());
  writeSymbolicModel(run.options.model / kTransitionsFile, model);
  manifest.measures["train/triplets"] = static_cast<double>(triplets.size());
  return true;
}

}  // namespace conceptplan::training
