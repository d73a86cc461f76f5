#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/domain/symbols.hpp"
#include "conceptplan/learner/concept_learner.hpp"
#include "conceptplan/learner/learned_symbols.hpp"
#include "conceptplan/learner/tokens.hpp"
#include "conceptplan/learner/visual_transition.hpp"
#include "conceptplan/pipeline/model_manifest.hpp"
#include "conceptplan/planners/plan_result.hpp"

namespace conceptplan {

/// What was read of one picture: its objects, in the order of their instance ids.
struct Percept {
  std::vector<std::uint8_t> instances;  ///< ids in the mask
  std::vector<Tokens> tokens;
  std::vector<SymbolBelief> beliefs;
  std::vector<std::array<bool, kNumConcepts>> fits;  ///< see `Symbolizer::fits`

  /// Position of an instance, or `instances.size()` if it is not seen.
  std::size_t position(std::uint8_t instance) const;
};

/// What was read of the pictures before and after a task.
struct TaskReading {
  Percept initial;
  Percept goal;
  std::vector<bool> initial_recognised;  ///< see `Model::recognises`
  std::vector<bool> goal_recognised;
  /// Of each object of `goal`: whether its ROTATION is the opposite of what its tokens say, see
  /// `Model::readTask`.
  std::vector<bool> turned_round;
};

/// Whether an object is told to be like none that was learned: a token fits no symbol, or its
/// picture is not recognised. @param fits see `Symbolizer::fits` @param recognised see
/// `Model::recognises`
bool isLikeNoneLearned(const std::array<bool, kNumConcepts>& fits, bool recognised);

/// A plan to be drawn, and what it starts from.
struct RenderQuery {
  const RgbdImage& initial;
  const Percept& percept;  ///< of `initial`
  std::uint8_t target;     ///< instance that the plan moves
  const Plan& plan;
};

struct ModelOptions {
  /// With which the networks of each call compute, >= 1. With one, results do not depend on how
  /// many there are; with more, calls are faster and the last bits of their results may be others.
  int threads = 1;
};

/// A trained model: reads pictures as symbols and draws what plans will look like. Immutable;
/// threads may share it.
class Model {
 public:
  /// Loads a model folder whose training is complete, every file checked.
  /// @throws InputError with all faults, std::invalid_argument if an option is out of range.
  explicit Model(const std::filesystem::path& folder, const ModelOptions& options = {});
  ~Model();
  Model(Model&&) noexcept;
  Model& operator=(Model&&) noexcept;

  const std::filesystem::path& folder() const;
  const ModelManifest& manifest() const;
  const SymbolicModel& symbolic() const;
  std::size_t numParameters() const;

  /// The networks and symbols alone, for measures and figures of what was learned. Their calls use
  /// the caller's Torch thread settings.
  const ConceptLearner& learner() const;
  const LearnedSymbols& symbols() const;
  const VisualTransition& transition() const;

  Percept perceive(const RgbdImage& image) const;
  /// The same for many pictures, all their objects encoded together.
  std::vector<Percept> perceive(std::span<const RgbdImage> images) const;

  /// Whether each object looks like what is drawn of its tokens, as pictures of learned objects do;
  /// else it is like none that was learned, and its symbols are guesses. It takes about as long as
  /// to perceive. @throws std::invalid_argument if the percept is not of that picture.
  std::vector<bool> recognises(const RgbdImage& image, const Percept& percept) const;

  /// Reads both pictures of a task. The tokens of an object like none that was learned may take
  /// its ROTATION for the opposite one. How it was turned between the pictures shows without
  /// learning (`turnResidual`): where half a turn more than its tokens say fits them much better,
  /// the goal's belief in its ROTATION is that half turn on, by the effect that was learned of
  /// turning. @throws std::invalid_argument if a picture is not 384 x 256.
  TaskReading readTask(const RgbdImage& initial, const RgbdImage& goal) const;

  /// The picture, depth and mask after each step of a plan, as ViCT predicts them, [actions].
  /// Tokens go through the causal transition; one that then reads as another symbol than the plan
  /// predicts is replaced by the centre of the predicted one, so that errors do not add up. A plan
  /// that says what each action moves, by position in the percept, moves that in place of the
  /// target; each turn to another object is drawn into the last frame before it.
  /// @throws std::invalid_argument if the target is not seen in the picture, or another object that
  /// moves is hidden in the frame; if the plan has no predicted symbols.
  std::vector<RgbdImage> render(const RgbdImage& initial, const Percept& percept,
                                std::uint8_t target, const Plan& plan) const;
  /// The same for many plans, all their steps drawn together; [plans], [actions] each.
  std::vector<std::vector<RgbdImage>> render(std::span<const RenderQuery> queries) const;

 private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

/// The folder of a model given as a scenario names it: a folder, or the name of a shipped model. A
/// relative folder is looked for from `base`, then from the working directory; shipped models in
/// the folder that the environment variable CONCEPTPLAN_MODELS names, then where this library was
/// installed, then in the source tree that it was built from.
/// @throws InputError that lists the places, if there is none.
std::filesystem::path findModel(const std::string& name, const std::filesystem::path& base = {});

}  // namespace conceptplan
