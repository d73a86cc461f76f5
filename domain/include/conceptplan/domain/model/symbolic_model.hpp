#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "conceptplan/domain/model/action_legality.hpp"
#include "conceptplan/domain/model/transition_model.hpp"

namespace conceptplan {

/// The counts from which the probabilities of a model were made, on its own contexts.
struct ModelEvidence {
  std::array<std::array<ContextCounts, kNumConcepts>, kNumActions> transitions;
  /// For each action the counts of {other action taken, this action taken} of each factor.
  std::array<std::vector<ContextCounts>, kNumActions> legality;
  std::array<double, kNumActions> steps{};  ///< steps seen of each action

  bool operator==(const ModelEvidence&) const = default;
};

/// All that a planner knows of the world: what symbols stand for in space, what actions do to them
/// and when actions are legal. Learned; nothing of it is a rule written by hand.
struct SymbolicModel {
  SymbolGrounding grounding;
  TransitionModel transitions;
  ActionLegality legality;
  ModelEvidence evidence;

  const ConceptCardinality& cardinality() const { return transitions.cardinality(); }
  bool operator==(const SymbolicModel&) const = default;
};

/// Version of the file format.
inline constexpr int kSymbolicModelVersion = 2;

/// The model as JSON text; `parseSymbolicModel(toJson(m), p) == m`.
std::string toJson(const SymbolicModel& model);

/// @param path stands in the faults. @throws InputError with every fault of the text.
SymbolicModel parseSymbolicModel(std::string_view json, const std::filesystem::path& path);

/// Writes to a temporary file of the same folder, then renames it.
/// @throws InputError if it cannot be written.
void writeSymbolicModel(const std::filesystem::path& path, const SymbolicModel& model);

/// @throws InputError with every fault of the file, or that it cannot be read.
SymbolicModel readSymbolicModel(const std::filesystem::path& path);

/// One action in words.
struct ActionDescription {
  Action action = Action::kMoveFront;
  std::string needs;       ///< e.g. "own POSITION_X is not 0"; "nothing" if always legal
  std::string does;        ///< e.g. "COLOR becomes that of the nearest Dyer"
  double probability = 0;  ///< of the most probable effect, mean over the contexts seen
};

/// What the model has learned of each action, in words made from the tables alone.
std::vector<ActionDescription> describe(const SymbolicModel& model);

}  // namespace conceptplan
