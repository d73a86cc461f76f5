#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <random>
#include <span>

#include "conceptplan/learner/training/chain_sampler.hpp"

namespace conceptplan {

/// The paper's pairs: images of a batch that differ in one concept, and which one it is; [P] each.
/// Images are numbered chain by chain, seven a chain.
struct ConceptPairs {
  torch::Tensor first;
  torch::Tensor second;
  torch::Tensor differing;  ///< [0, 6)
};

/// The neighbours in each chain that differ.
ConceptPairs pairsOf(std::span<const ConceptChain> chains);

/// What a network makes of B images.
struct ReadImages {
  torch::Tensor planes;    ///< [B, 5, E, E]
  torch::Tensor location;  ///< [B, 3]
  torch::Tensor z;         ///< [B, channels, 8, 8]
  torch::Tensor tokens;    ///< [B, 6, 64]
};

/// Pairs to draw: the first image from its own tokens, and the second from the first's with the
/// token of the concept that differs taken from the second. Source: Eq. (1) of arXiv 2310.03325.
struct PairsToDraw {
  torch::Tensor first;     ///< [P]: of each pair
  torch::Tensor tokens;    ///< [2P, 6, 64]: the first images' own, then those with one substituted
  torch::Tensor truth;     ///< [2P, 5, E, E]: what is to be drawn from them, planes of the images
  torch::Tensor location;  ///< [2P, 3]: of these images
};

/// At most `count` of the pairs, drawn without repetition.
PairsToDraw choosePairs(const ConceptPairs& pairs, const ReadImages& read, std::int64_t count,
                        std::mt19937_64& generator);

}  // namespace conceptplan
