#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "conceptplan/learner/disentanglement/disentanglement_scores.hpp"
#include "conceptplan/learner/tokens.hpp"
#include "conceptplan/learner/training/concept_images.hpp"

namespace conceptplan {

/// How well the six tokens of pictures keep the six concepts apart. Values are used to measure,
/// never to learn. DCI sums importances within a token; the other measures take a token's first
/// principal component. @throws std::invalid_argument as `checkFactorCodes`
DisentanglementScores tokenScores(const std::vector<Tokens>& tokens,
                                  const std::vector<ConceptValues>& values, std::uint64_t seed);

/// Adds them to a manifest's measures as "SPLIT/dci", "SPLIT/dci_completeness",
/// "SPLIT/dci_informativeness", "SPLIT/mig", "SPLIT/sap", "SPLIT/factor_vae" and "SPLIT/beta_vae".
void addTokenScores(const DisentanglementScores& scores, const std::string& split,
                    std::map<std::string, double>& measures);

}  // namespace conceptplan
