#include "conceptplan/pipeline/figures.hpp"

#include <algorithm>

#include "figure_parts.hpp"
#include "torch_threads.hpp"

namespace conceptplan {
namespace {

/// Up to `most` pictures of the set, drawn without repetition.
std::vector<figures::ReadObject> readObjects(const Model& model, const ConceptDataset& data,
                                             std::size_t most, std::mt19937_64& generator) {
  std::vector<std::size_t> positions(data.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    positions[i] = i;
    std::swap(positions[i], positions[generator() % (i + 1)]);
  }
  positions.resize(std::min(most, positions.size()));
  std::vector<figures::ReadObject> objects;
  std::vector<EncoderInput> inputs;
  for (const std::size_t position : positions) {
    objects.push_back({data.sample(position), {}, {}});
    inputs.push_back(encoderInput(objects.back().sample.crop));
  }
  const std::vector<Tokens> tokens = model.learner().encode(inputs);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    objects[i].tokens = tokens[i];
    objects[i].symbols = model.symbols().symbolizer.nearest(tokens[i]);
  }
  return objects;
}

}  // namespace

std::vector<Figure> drawFigures(const Model& model, const ConceptDataset& data,
                                const FigureOptions& options) {
  const TorchThreads one_thread(1);
  std::mt19937_64 generator(options.seed);
  figures::Material material{model, readObjects(model, data, options.pictures, generator), ""};
  material.set = std::to_string(material.objects.size()) + " pictures of the " +
                 std::string(name(data.options().split)) + " split";
  const figures::Effects effects = figures::applyActions(material, generator);
  return {figures::substitutionGrid(material, generator), figures::tokenChanges(material, effects),
          figures::displacements(material, effects), figures::clusters(material)};
}

}  // namespace conceptplan
