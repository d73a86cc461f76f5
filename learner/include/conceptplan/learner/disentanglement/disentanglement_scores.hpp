#pragma once

#include <cstdint>

#include "conceptplan/learner/disentanglement/dci.hpp"
#include "conceptplan/learner/disentanglement/factor_codes.hpp"

namespace conceptplan {

// Each measure below takes one number a token (`principalCodes`), is deterministic for its seed,
// and throws std::invalid_argument as `checkFactorCodes`.

/// Mutual information gap, in [0, 1]: for each factor the information that the best token has on it
/// less that of the second best, over the factor's entropy; mean over factors. Codes are cut into
/// 20 bins of equal width. Source: Chen et al., Isolating Sources of Disentanglement in VAEs,
/// NeurIPS 2018, arXiv 1802.04942; the bins are those of Locatello et al., arXiv 1811.12359.
double mutualInformationGap(const FactorCodes& data);

/// Separated attribute predictability, in [0, 1]: for each factor the balanced accuracy of the best
/// token less that of the second best; mean over factors. A token tells a factor of V values by V -
/// 1 thresholds, the best there are on one half of the pictures, scored on the other. Perfect codes
/// score 1 less chance, the mean of 1 - 1/V. Source: Kumar et al., Variational Inference of
/// Disentangled Latent Concepts from Unlabeled Observations, ICLR 2018, arXiv 1711.00848.
double separatedAttributePredictability(const FactorCodes& data, std::uint64_t seed = 0);

/// FactorVAE score: how often the token that varies least, relative to its variance in all
/// pictures, tells which factor was held fixed in 64 pictures, by majority vote. Chance is 1/K.
/// 5,000 votes are taken to learn from, 2,500 to score. Source: Kim and Mnih, Disentangling by
/// Factorising, ICML 2018, arXiv 1802.05983.
double factorVaeScore(const FactorCodes& data, std::uint64_t seed = 0);

/// beta-VAE score: accuracy of a linear classifier (multinomial logistic regression) that is told
/// the mean absolute difference of the codes of 64 pairs of pictures, and tells which factor the
/// two of each pair share. Chance is 1/K. 5,000 examples to learn from, 2,500 to score; codes are
/// scaled to unit variance. Source: Higgins et al., beta-VAE, ICLR 2017.
double betaVaeScore(const FactorCodes& data, std::uint64_t seed = 0);

/// All measures at once.
struct DisentanglementScores {
  DciScores dci;
  double mig = 0;
  double sap = 0;
  double factor_vae = 0;
  double beta_vae = 0;
};
DisentanglementScores disentanglementScores(const FactorCodes& data, std::uint64_t seed = 0);

}  // namespace conceptplan
