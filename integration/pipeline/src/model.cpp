#include "conceptplan/pipeline/model.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <utility>

#include "conceptplan/domain/files/atomic_file.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/learner/background.hpp"
#include "conceptplan/learner/effect_context.hpp"
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

}  // namespace

std::size_t Percept::position(std::uint8_t instance) const {
  return static_cast<std::size_t>(std::find(instances.begin(), instances.end(), instance) -
                                  instances.begin());
}

struct Model::Parts {
  std::filesystem::path folder;
  ModelManifest manifest;
  std::size_t parameters;
  ConceptLearner learner;
  LearnedSymbols symbols;
  SymbolicModel symbolic;
  VisualTransition transition;
};

Model::Model(const std::filesystem::path& folder) {
  ModelManifest manifest = completeManifest(folder);
  const NamedTensors concepts = readTensors(folder / kConceptsFile);
  const NamedTensors vict = readTensors(folder / kVictFile);
  const EncoderKind encoder = manifest.encoder;
  parts_ = std::make_unique<const Parts>(Parts{
      folder, std::move(manifest), count(concepts) + count(vict),
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
  const TorchThreads one_thread(1);
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

std::vector<RgbdImage> Model::render(const RgbdImage& initial, const Percept& percept,
                                     std::uint8_t target, const Plan& plan) const {
  const std::size_t at = percept.position(target);
  if (at == percept.instances.size())
    throw std::invalid_argument("Model::render: instance " + std::to_string(target) +
                                " is not in the picture");
  if (plan.predicted.size() != plan.actions.size())
    throw std::invalid_argument("Model::render: " + std::to_string(plan.predicted.size()) +
                                " predicted states for " + std::to_string(plan.actions.size()) +
                                " actions");
  const TorchThreads one_thread(1);
  const Symbolizer& symbolizer = parts_->symbols.symbolizer;
  std::vector<Tokens> tokens = percept.tokens;
  std::vector<Symbols> symbols;
  for (const SymbolBelief& belief : percept.beliefs) symbols.push_back(mostProbable(belief));
  std::vector<std::size_t> moved = plan.moved;
  moved.resize(plan.actions.size(), at);
  for (const std::size_t object : moved)
    if (object >= percept.instances.size())
      throw std::invalid_argument("Model::render: the plan moves object " + std::to_string(object) +
                                  " of " + std::to_string(percept.instances.size()));
  std::vector<Tokens> predicted;
  for (std::size_t step = 0; step < plan.actions.size(); ++step) {
    const Action action = plan.actions[step];
    const std::size_t object = moved[step];
    const Tokens context = effectContext(parts_->symbolic, action, symbols.at(object),
                                         without(symbols, object), without(tokens, object));
    tokens[object] = parts_->transition.apply(tokens[object], context, action);
    symbols[object] = plan.predicted[step];
    const Symbols read = symbolizer.nearest(tokens[object]);
    for (const Concept which : kConcepts) {
      const std::size_t k = index(which);
      if (read[k] != symbols[object][k])
        tokens[object].row(static_cast<Eigen::Index>(k)) = symbolizer.clusters(which).centers.row(
            static_cast<Eigen::Index>(index(symbols[object][k])));
    }
    predicted.push_back(tokens[object]);
  }
  // As long as one object moves, it is drawn into the same picture.
  std::optional<Background> background;
  std::vector<RgbdImage> frames;
  for (const DrawnObject& drawn : parts_->learner.draw(predicted)) {
    const std::size_t step = frames.size();
    const std::uint8_t instance = percept.instances[moved[step]];
    if (step == 0 || moved[step] != moved[step - 1])
      background = backgroundWithout(step == 0 ? initial : frames.back(), instance);
    frames.push_back(parts_->transition.synthesize(*background, instance, drawn));
  }
  return frames;
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
