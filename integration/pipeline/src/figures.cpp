#include "conceptplan/pipeline/figures.hpp"

#include <algorithm>

#include "conceptplan/pipeline/concept_evaluation.hpp"
#include "figure_parts.hpp"
#include "torch_threads.hpp"

namespace conceptplan {
namespace {

/// As many pictures of the set as the options allow, none twice.
std::vector<figures::ReadObject> readObjects(const Model& model, const ConceptDataset& data,
                                             const FigureOptions& options,
                                             std::mt19937_64& generator) {
  constexpr std::size_t kBatch = 128;  // pictures that are encoded at once
  std::vector<std::size_t> positions(data.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positions[i] = i;
    std::swap(positions[i], positions[generator() % (i + 1)]);
  }
  positions.resize(std::min(options.pictures, positions.size()));
  std::vector<figures::ReadObject> objects;
  std::vector<EncoderInput> inputs;
  for (const std::size_t position : positions) {
    objects.emplace_back().sample = data.sample(position);
    inputs.push_back(encoderInput(objects.back().sample.crop));
  }
  for (std::size_t begin = 0; begin < objects.size(); begin += kBatch) {
    const std::size_t count = std::min(kBatch, objects.size() - begin);
    const std::vector<Tokens> tokens = model.learner().encode({inputs.data() + begin, count});
    for (std::size_t i = 0; i < count; ++i) {
      objects[begin + i].tokens = tokens[i];
      objects[begin + i].symbols = model.symbols().symbolizer.nearest(tokens[i]);
    }
    if (options.progress) options.progress(begin + count, objects.size());
  }
  return objects;
}

}  // namespace

std::vector<Figure> drawFigures(const Model& model, const ConceptDataset& data,
                                const FigureOptions& options) {
  requireSameSplit(data, model);
  const TorchThreads one_thread(1);
  std::mt19937_64 generator(options.seed);
  figures::Material material{model, readObjects(model, data, options, generator), ""};
  material.set = std::to_string(material.objects.size()) + " pictures of the " +
                 std::string(name(data.options().split)) + " split";
  const figures::Effects effects = figures::applyActions(material, generator);
  return {figures::substitutionGrid(material, generator), figures::tokenChanges(material, effects),
          figures::displacements(material, effects), figures::clusters(material)};
}

}  // namespace conceptplan
