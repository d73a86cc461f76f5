#pragma once

#include <random>
#include <string>
#include <vector>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/pipeline/figures.hpp"

namespace conceptplan::figures {

/// One object of the set and how the model reads it.
struct ReadObject {
  ConceptSample sample;
  Tokens tokens = Tokens::Zero();
  Symbols symbols;
};

/// What the figures are drawn from.
struct Material {
  const Model& model;
  std::vector<ReadObject> objects;
  std::string set;  ///< e.g. "1,000 pictures of the test split"
};

// Each draws one figure; see `drawFigures`.

Figure substitutionGrid(const Material& material, std::mt19937_64& generator);
Figure clusters(const Material& material);

/// The objects before and after each action that is legal there, by the causal transition.
struct Effects {
  struct Step {
    Tokens before;
    Tokens after;
  };
  std::array<std::vector<Step>, kNumActions> steps;
};
/// Beside each object stands one other object of each TYPE symbol, drawn at random.
Effects applyActions(const Material& material, std::mt19937_64& generator);

Figure tokenChanges(const Material& material, const Effects& effects);
Figure displacements(const Material& material, const Effects& effects);

}  // namespace conceptplan::figures
