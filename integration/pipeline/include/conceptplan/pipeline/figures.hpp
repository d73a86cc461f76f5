#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "conceptplan/domain/dataset/concept_dataset.hpp"
#include "conceptplan/pipeline/model.hpp"

namespace conceptplan {

/// A drawing that stands alone.
struct Figure {
  std::string name;  ///< of its file, without ending
  std::string svg;
};

struct FigureOptions {
  std::size_t pictures = 1000;  ///< most pictures that are read
  std::uint64_t seed = 0;       ///< decides which
  std::function<void(std::size_t done, std::size_t total)> progress;  ///< pictures read
};

/// What a model has learned, drawn from pictures that training did not see:
/// - `substitution-grid`: objects with each of their tokens replaced by another object's, as they
///   are drawn, and where. Source: Fig. "concept exp" of arXiv 2310.03325.
/// - `token-changes`: mean l2 norm of the change of each token under each action that is legal, by
///   the causal transition T. Source: Fig. "action concept eff" (a).
/// - `displacements`: how T moves objects by each action, in cells: the position tokens are read by
///   the linear map of least norm that sends the centre of each symbol to its column or row.
///   Source: the same figure (b).
/// - `clusters`: the first two principal components of each concept's tokens, by symbol.
/// Equal arguments give equal bytes.
/// @throws InputError if a picture is damaged.
/// @throws std::invalid_argument if the set has no two objects that differ in all six concepts.
std::vector<Figure> drawFigures(const Model& model, const ConceptDataset& data,
                                const FigureOptions& options = {});

}  // namespace conceptplan
