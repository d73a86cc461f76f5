#include "conceptplan/pipeline/model.hpp"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/object_crop.hpp"
#include "conceptplan/learner/background.hpp"
#include "conceptplan/learner/effect_context.hpp"
#include "half_turn.hpp"
#include "observed_frame.hpp"
#include "torch_threads.hpp"

namespace conceptplan {
namespace {

NamedTensors readTensors(const std::filesystem::path& path) {
  return decodeTensors(readFile(path), path);
}

ModelManifest completeManifest(const std::filesystem::path& folder) {
  ModelManifest manifest = readModelManifest(folder);
  if (manifest.stages.size() < kNumTrainingStages)
    throw InputError({{folder.string(), std::nullopt, std::nullopt, "stages",
                       "the model's training is not complete; go on with conceptplan train all "
                       "--resume"}});
  return manifest;
}

std::size_t count(const NamedTensors& tensors) {
  std::size_t total = 0;
  for (const auto& [name, tensor] : tensors) total += tensor.values.size();
  return total;
}

template <typename Value>
std::vector<Value> without(std::vector<Value> values, std::size_t at) {
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(at));
  return values;
}

/// A plan on its way to its frames.
struct PlanDrawing {
  RenderQuery query;
  std::vector<std::size_t> moved;  ///< [actions], position in the percept of what each moves
  std::vector<Tokens> tokens;      ///< of each object, after the steps predicted so far
  std::vector<Symbols> symbols;    ///< of each object
  std::vector<Tokens> predicted;   ///< of what each step moves, after it
  std::vector<DrawnObject> drawn;  ///< the same objects
  std::optional<Background> background;
  std::vector<RgbdImage> frames;

  explicit PlanDrawing(const RenderQuery& of) : query(of), moved(of.plan.moved) {
    const Percept& percept = query.percept;
    const Plan& plan = query.plan;
    const std::size_t at = percept.position(query.target);
    if (at == percept.instances.size())
      throw std::invalid_argument("Model::render: instance " + std::to_string(query.target) +
                                  " is not in the picture");
    if (plan.predicted.size() != plan.actions.size())
      throw std::invalid_argument("Model::render: " + std::to_string(plan.predicted.size()) +
                                  " predicted states for " + std::to_string(plan.actions.size()) +
                                  " actions");
    moved.resize(plan.actions.size(), at);
    for (const std::size_t object : moved)
      if (object >= percept.instances.size())
        throw std::invalid_argument("Model::render: the plan moves object " +
                                    std::to_string(object) + " of " +
                                    std::to_string(percept.instances.size()));
    tokens = percept.tokens;
    for (const SymbolBelief& belief : percept.beliefs) symbols.push_back(mostProbable(belief));
  }

  /// What the causal transition is asked for the next step.
  TransitionInput nextStep(const SymbolicModel& model) const {
    const std::size_t object = moved[predicted.size()];
    const Action action = query.plan.actions[predicted.size()];
    return {tokens[object],
            effectContext(model, action, symbols.at(object), without(symbols, object),
                          without(tokens, object)),
            action};
  }

  /// Takes its answer, without what reads as another symbol than the plan predicts.
  void take(const Tokens& next, const Symbolizer& symbolizer) {
    const std::size_t object = moved[predicted.size()];
    tokens[object] = next;
    symbols[object] = query.plan.predicted[predicted.size()];
    const Symbols read = symbolizer.nearest(next);
    for (const Concept which : kConcepts) {
      const std::size_t k = index(which);
      if (read[k] != symbols[object][k])
        tokens[object].row(static_cast<Eigen::Index>(k)) = symbolizer.clusters(which).centers.row(
            static_cast<Eigen::Index>(index(symbols[object][k])));
    }
    predicted.push_back(tokens[object]);
  }

  /// What is to be drawn of the next steps that move one object, which come into one background.
  std::vector<SynthesisInput> nextTurn() {
    const std::size_t first = frames.size();
    const std::uint8_t instance = query.percept.instances[moved[first]];
    background = backgroundWithout(first == 0 ? query.initial : frames.back(), instance);
    std::vector<SynthesisInput> inputs;
    for (std::size_t step = first; step < moved.size() && moved[step] == moved[first]; ++step)
      inputs.push_back({*background, instance, drawn[step]});
    return inputs;
  }
};

}  // namespace

std::size_t Percept::position(std::uint8_t instance) const {
  return static_cast<std::size_t>(std::find(instances.begin(), instances.end(), instance) -
                                  instances.begin());
}

bool isLikeNoneLearned(const std::array<bool, kNumConcepts>& fits, bool recognised) {
  return !recognised || std::ranges::count(fits, false) > 0;
}

struct Model::Parts {
  std::filesystem::path folder;
  ModelOptions options;
  ModelManifest manifest;
  std::size_t parameters;
  ConceptLearner learner;
  LearnedSymbols symbols;
  SymbolicModel symbolic;
  VisualTransition transition;
};

Model::Model(const std::filesystem::path& folder, const ModelOptions& options) {
  if (options.threads < 1)
    throw std::invalid_argument("threads is " + std::to_string(options.threads) +
                                ", expected >= 1");
  ModelManifest manifest = completeManifest(folder);
  const NamedTensors concepts = readTensors(folder / kConceptsFile);
  const NamedTensors vict = readTensors(folder / kVictFile);
  const EncoderKind encoder = manifest.encoder;
  parts_ = std::make_unique<const Parts>(Parts{
      folder, options, std::move(manifest), count(concepts) + count(vict),
      ConceptLearner(concepts, encoder, folder / kConceptsFile),
      learnedSymbolsFrom(readTensors(folder / kSymbolsFile), folder / kSymbolsFile),
      readSymbolicModel(folder / kTransitionsFile), VisualTransition(vict, folder / kVictFile)});
  if (parts_->symbols.symbolizer.cardinality() != parts_->symbolic.cardinality())
    throw InputError({{(folder / kTransitionsFile).string(), std::nullopt, std::nullopt,
                       "cardinality", "does not fit the model's symbols"}});
}

Model::~Model() = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;

const std::filesystem::path& Model::folder() const { return parts_->folder; }
const ModelManifest& Model::manifest() const { return parts_->manifest; }
const SymbolicModel& Model::symbolic() const { return parts_->symbolic; }
std::size_t Model::numParameters() const { return parts_->parameters; }
const ConceptLearner& Model::learner() const { return parts_->learner; }
const LearnedSymbols& Model::symbols() const { return parts_->symbols; }
const VisualTransition& Model::transition() const { return parts_->transition; }

Percept Model::perceive(const RgbdImage& image) const {
  return std::move(perceive({&image, 1}).front());
}

std::vector<Percept> Model::perceive(std::span<const RgbdImage> images) const {
  const TorchThreads threads(parts_->options.threads);
  const Symbolizer& symbolizer = parts_->symbols.symbolizer;
  std::vector<Percept> percepts;
  for (ObservedFrame& observed : observeFrames(parts_->learner, images)) {
    Percept& percept = percepts.emplace_back();
    percept.instances = std::move(observed.instances);
    percept.tokens = std::move(observed.tokens);
    for (const Tokens& tokens : percept.tokens) {
      percept.beliefs.push_back(symbolizer.belief(tokens));
      percept.fits.push_back(symbolizer.fits(tokens));
    }
  }
  return percepts;
}

std::vector<bool> Model::recognises(const RgbdImage& image, const Percept& percept) const {
  if (percept.tokens.size() != percept.instances.size())
    throw std::invalid_argument("a percept of " + std::to_string(percept.instances.size()) +
                                " instances has the tokens of " +
                                std::to_string(percept.tokens.size()));
  const TorchThreads threads(parts_->options.threads);
  const std::vector<DrawnObject> drawn = parts_->learner.draw(percept.tokens);
  std::vector<bool> recognised;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const std::uint8_t instance = percept.instances[i];
    const EncoderInput seen = encoderInput(cropObject(image, instance));
    const PictureResidual residual =
        pictureResidual(seen, drawn[i], hiddenPixels(image, instance, seen));
    recognised.push_back(residual.within(parts_->symbols.most_residual));
  }
  return recognised;
}

TaskReading Model::readTask(const RgbdImage& initial, const RgbdImage& goal) const {
  for (const RgbdImage* picture : {&initial, &goal})
    if (picture->width != kFrameWidth || picture->height != kFrameHeight)
      throw std::invalid_argument("Model::readTask: a picture of " +
                                  std::to_string(picture->width) + " x " +
                                  std::to_string(picture->height) + ", expected 384 x 256");
  TaskReading read{perceive(initial), perceive(goal), {}, {}, {}};
  read.initial_recognised = recognises(initial, read.initial);
  read.goal_recognised = recognises(goal, read.goal);
  read.turned_round.assign(read.goal.instances.size(), false);
  for (std::size_t i = 0; i < read.goal.instances.size(); ++i) {
    const std::uint8_t instance = read.goal.instances[i];
    const std::size_t before = read.initial.position(instance);
    if (before == read.initial.instances.size()) continue;
    if (!isLikeNoneLearned(read.initial.fits[before], read.initial_recognised[before]) &&
        !isLikeNoneLearned(read.goal.fits[i], read.goal_recognised[i]))
      continue;
    SymbolBelief& belief = read.goal.beliefs[i];
    read.turned_round[i] =
        isTurnedRound(parts_->symbolic, {initial, instance, read.initial.beliefs[before]},
                      {goal, instance, belief});
    if (read.turned_round[i]) belief = turnedRound(parts_->symbolic, belief);
  }
  return read;
}

std::vector<RgbdImage> Model::render(const RgbdImage& initial, const Percept& percept,
                                     std::uint8_t target, const Plan& plan) const {
  const RenderQuery query{initial, percept, target, plan};
  return std::move(render({&query, 1}).front());
}

std::vector<std::vector<RgbdImage>> Model::render(std::span<const RenderQuery> queries) const {
  const TorchThreads threads(parts_->options.threads);
  std::vector<PlanDrawing> drawings(queries.begin(), queries.end());

  // Each step starts from the tokens of the one before.
  while (true) {
    std::vector<TransitionInput> inputs;
    std::vector<PlanDrawing*> asking;
    for (PlanDrawing& drawing : drawings) {
      if (drawing.predicted.size() == drawing.moved.size()) continue;
      inputs.push_back(drawing.nextStep(parts_->symbolic));
      asking.push_back(&drawing);
    }
    if (inputs.empty()) break;
    const std::vector<Tokens> results = parts_->transition.apply(inputs);
    for (std::size_t i = 0; i < results.size(); ++i)
      asking[i]->take(results[i], parts_->symbols.symbolizer);
  }

  std::vector<Tokens> tokens;
  for (const PlanDrawing& drawing : drawings)
    tokens.insert(tokens.end(), drawing.predicted.begin(), drawing.predicted.end());
  std::vector<DrawnObject> objects = parts_->learner.draw(tokens);
  auto object = std::make_move_iterator(objects.begin());
  for (PlanDrawing& drawing : drawings) {
    const auto last = object + static_cast<std::ptrdiff_t>(drawing.moved.size());
    drawing.drawn.assign(object, last);
    object = last;
  }

  // Each turn to another object starts from the last frame before it.
  while (true) {
    std::vector<SynthesisInput> inputs;
    std::vector<PlanDrawing*> asking;
    for (PlanDrawing& drawing : drawings) {
      if (drawing.frames.size() == drawing.moved.size()) continue;
      for (const SynthesisInput& input : drawing.nextTurn()) {
        inputs.push_back(input);
        asking.push_back(&drawing);
      }
    }
    if (inputs.empty()) break;
    std::vector<RgbdImage> frames = parts_->transition.synthesize(inputs);
    for (std::size_t i = 0; i < frames.size(); ++i)
      asking[i]->frames.push_back(std::move(frames[i]));
  }

  std::vector<std::vector<RgbdImage>> result;
  for (PlanDrawing& drawing : drawings) result.push_back(std::move(drawing.frames));
  return result;
}

std::filesystem::path findModel(const std::string& name, const std::filesystem::path& base) {
  std::vector<std::filesystem::path> places;
  if (!base.empty()) places.push_back(base / name);
  places.emplace_back(name);
  if (const char* models = std::getenv("CONCEPTPLAN_MODELS"))
    places.push_back(std::filesystem::path(models) / name);
  places.push_back(std::filesystem::path(CONCEPTPLAN_INSTALLED_MODELS) / name);
  places.push_back(std::filesystem::path(CONCEPTPLAN_SOURCE_MODELS) / name);
  std::string tried;
  for (const auto& place : places) {
    if (std::filesystem::exists(place / kModelManifestFile)) return place;
    tried += (tried.empty() ? "" : ", ") + place.string();
  }
  throw InputError(
      {{name, std::nullopt, std::nullopt, "model",
        "no such model; looked for " + std::string(kModelManifestFile) + " in " + tried}});
}

}  // namespace conceptplan
