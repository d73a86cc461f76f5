#include "conceptplan/learner/disentanglement/disentanglement_scores.hpp"

namespace conceptplan {

DisentanglementScores disentanglementScores(const FactorCodes& data, std::uint64_t seed) {
  return {dciScores(data, seed), mutualInformationGap(data),
          separatedAttributePredictability(data, seed), factorVaeScore(data, seed),
          betaVaeScore(data, seed)};
}

}  // namespace conceptplan
