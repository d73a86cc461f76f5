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
  double misread_share = 0.15;
  /// Steps' worth of the prior share in each estimate of legality; > 0.
  double prior_steps = 8;
  /// A context makes an action illegal below this Pr[a | Omega]; guides the selection of factors.
  double legality_threshold = 0.01;
  /// A share counts as none if misreading explains it this many times over; >= 0.
  double misread_slack = 2;
  /// Most factors of one action's legality.
  std::size_t max_legality_factors = 8;
  /// Most features in the context of one effect.
  std::size_t max_effect_features = 2;
};

/// Estimates effects and legality of all actions from triplets.
///
/// Effects. Pr[next symbol | context] per action and concept. The context is selected by BIC:
/// starting from nothing, the candidate that lowers -2 log L + p log n most is added while it
/// lowers it. Candidates: the target's six symbols, and the concept's symbol of the nearest object
/// of each TYPE symbol. The target's own symbol of the concept wins ties.
///
/// Legality. Pr[a | value of a feature] with all actions weighed alike, so that rare actions are
/// not illegal for being rare. Factors are found by sequential covering: of the steps that no
/// factor rules out yet, the candidate with the highest BIC gain (a taken or not, table against one
/// share) that rules out a value is added. Candidates: the target's six symbols, and the offset
/// to the nearest object of each TYPE symbol. Every share backs off to the prior (1 / 7) with
/// `prior_steps`, so contexts never seen stay legal; the absence of an object never rules out an
/// action, since tasks without it may not have asked for it.
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
