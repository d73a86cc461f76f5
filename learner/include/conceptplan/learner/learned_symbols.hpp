#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "conceptplan/domain/model/symbol_grounding.hpp"
#include "conceptplan/learner/picture_residual.hpp"
#include "conceptplan/learner/symbolizer.hpp"
#include "conceptplan/learner/tensor_file.hpp"

namespace conceptplan {

/// The symbols of a model: how tokens become symbols, and what the symbols stand for in space.
struct LearnedSymbols {
  Symbolizer symbolizer;
  SymbolGrounding grounding;  ///< its names follow from `values`
  /// The value that most validation objects of each symbol show; for people and for measures only.
  std::array<std::vector<int>, kNumConcepts> values;
  /// What pictures of learned objects hardly ever exceed; see `pictureResidual`.
  PictureResidual most_residual;
};

/// The names of symbols that stand for those values, e.g. "Cup", "red", "90 degrees".
std::array<std::vector<std::string>, kNumConcepts> symbolNames(
    const std::array<std::vector<int>, kNumConcepts>& values);

NamedTensors tensorsOf(const LearnedSymbols& symbols);

/// @param path stands in the faults. @throws InputError if tensors are missing, misshaped or hold
/// impossible values.
LearnedSymbols learnedSymbolsFrom(const NamedTensors& tensors, const std::filesystem::path& path);

}  // namespace conceptplan
