#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "conceptplan/domain/action.hpp"
#include "conceptplan/domain/model/symbolic_model.hpp"

namespace conceptplan {

/// One recorded step of the training data, as symbols. The paper's (input, action, output).
struct Triplet {
  std::vector<Symbols> objects;  ///< before the action, all on the workbench
  std::size_t target = 0;        ///< index into `objects`
  Action action = Action::kMoveFront;
  Symbols after{};  ///< of the target, after the action

  bool operator==(const Triplet&) const = default;
};

struct TransitionEstimationOptions {
  /// An outcome with a smaller share of its context's steps counts as a misread symbol and gets no
  /// probability; in [0, 0.5).
  double misread_share = 0.25;
  /// Steps in which the symbol stays that are added to every context; >= 0.
  double stay_steps = 1;
  /// Uses of an action, as many as expected, that are added where it was taken; > 0.
  double prior_uses = 0.5;
  /// A context makes an action illegal below this Pr[a | Omega]; guides the selection of factors.
  double legality_threshold = 0.01;
  /// Least share of misread symbols of a concept; more is taken from outcomes that count as
  /// misread. Steps alone do not show an object that is read wrongly all the time; in [0, 1].
  double misread_floor = 0.02;
  /// Uses of an action count as none if misreading explains them this many times over; >= 0.
  double misread_slack = 2;
  /// Most factors of one action's legality.
  std::size_t max_legality_factors = 12;
  /// Most features in the context of one effect.
  std::size_t max_effect_features = 2;
};

/// Estimates effects and legality of all actions from triplets.
///
/// Effects: Pr[next symbol | context] per action and concept. The context is selected by BIC,
/// -2 log L + p log n. The simplest model has one parameter: the probability that the symbol stays.
/// Against it stands a table whose context grows greedily from nothing while BIC falls, out of the
/// target's six symbols and the concept's symbol of the nearest object of each TYPE symbol. Steps
/// without the object of a chosen feature are set aside. In a context that was never seen the
/// symbol stays.
///
/// Legality: Pr[a | value of a feature], with all actions weighed alike so that a rare one is not
/// illegal for being rare. Factors are found by sequential covering: of the steps that no factor
/// rules out yet, the feature with the highest BIC gain (a taken or not, a table against one
/// share) that rules out some value is added. A value at which the action was never taken is ruled
/// out by how many uses were to be expected there, the more readily the more values of the feature
/// are ruled out already (empirical Bayes). Candidates are the target's six symbols and the
/// offset to the nearest object of each TYPE symbol. What was never seen stays legal, and so does
/// every action where an object is absent: tasks without it may not have asked for the action.
///
/// Source: Sec. III-B of arXiv 2310.03325 ("recording the (input, action, output) triplets"); the
/// selection of contexts is ours. BIC: G. Schwarz, doi:10.1214/aos/1176344136.
///
/// @throws std::invalid_argument if there is no triplet, or one does not fit the cardinality, or
/// the grounding has faults, or an option is out of range.
SymbolicModel estimateSymbolicModel(std::span<const Triplet> triplets,
                                    const SymbolGrounding& grounding,
                                    const ConceptCardinality& cardinality,
                                    const TransitionEstimationOptions& options = {});

}  // namespace conceptplan
