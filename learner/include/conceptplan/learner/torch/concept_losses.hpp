#pragma once

#include <torch/torch.h>

#include "conceptplan/learner/torch/concept_network.hpp"
#include "conceptplan/learner/training/concept_training_options.hpp"

namespace conceptplan {

/// Squared error of a drawn object against the truth, each pixel of the object weighted
/// `foreground_weight` times one of the background, plus that of its depth where the object is, and
/// the cross-entropy of its mask. planes [B, 5, E, E] as of `EncoderInput`, in 0..1 -> scalar.
/// Source: L_MSE in Eq. (1) of arXiv 2310.03325; weight, depth and mask are ours.
torch::Tensor reconstructionLoss(const DecodedObject& drawn, const torch::Tensor& planes,
                                 double foreground_weight);

/// Both errors of Eq. (1), each as above: of the first images of P pairs, drawn from their own
/// tokens, and of the second ones, drawn after one token was substituted. drawn [2P, ...], planes
/// [2P, 5, E, E], as of `PairsToDraw` -> scalar.
torch::Tensor pairReconstructionLoss(const DecodedObject& drawn, const torch::Tensor& planes,
                                     double foreground_weight);

/// Absolute error of a drawn object's colours, weighted as above; unlike the squared one it does
/// not favour blurred edges. planes [B, 5, E, E] as of `EncoderInput`, in 0..1 -> scalar. Source:
/// Sec. 3.1 of P. Isola et al., CVPR 2017, arXiv 1611.07004.
torch::Tensor absoluteColorLoss(const DecodedObject& drawn, const torch::Tensor& planes,
                                double foreground_weight);

/// Concept disentangling loss: the token of the concept that differs should differ most.
/// first, second [B, 6, 64]; differing [B] in [0, 6) -> scalar. Source: Eq. (2).
torch::Tensor conceptDisentanglingLoss(const torch::Tensor& first, const torch::Tensor& second,
                                       const torch::Tensor& differing);

/// Negative log likelihood that two images of a group show the same value of a concept, or
/// different ones, each pair kind averaged apart.
/// log_values [G, N, n]: logarithm of each image's distribution over prototypes; changed [G, N]:
/// the side of each image, 0 or 1. Images of one side show the same value, those of two sides
/// differ
/// -> scalar.
/// Source: meta classification likelihood, Hsu et al., ICLR 2019 (arXiv 1901.00544), on the
/// paper's pairs.
torch::Tensor pairLikelihoodLoss(const torch::Tensor& log_values, const torch::Tensor& changed);

/// How far the prototypes' mean use is from uniform: log(n) minus its entropy, 0 at best.
/// values [B, n] -> scalar.
torch::Tensor prototypeUseLoss(const torch::Tensor& values);

/// Mean entropy of single images over prototypes. Low while the mean use stays even, it is the
/// mutual information of image and prototype (RIM, Krause et al., NIPS 2010); without it two values
/// can rest shared half and half between two prototypes. values [B, n] -> scalar.
torch::Tensor prototypeEntropy(const torch::Tensor& values);

/// What a step of the first two phases learns from, scalars; those of what does not learn in it
/// stay 0.
struct ConceptTerms {
  torch::Tensor disentangling = torch::zeros({});   ///< Eq. (2)
  torch::Tensor reconstruction = torch::zeros({});  ///< Eq. (1)
  torch::Tensor direct = torch::zeros({});          ///< reconstruction from Z, without tokens
  torch::Tensor location = torch::zeros({});        ///< error of where the crops lie
  torch::Tensor pair = torch::zeros({});            ///< pair likelihood of all concepts
  torch::Tensor use = torch::zeros({});             ///< even use of their prototypes
  torch::Tensor confidence = torch::zeros({});      ///< entropy of single images
};

/// Total loss: disentangling + reconstruction + direct are Eq. (3) of arXiv 2310.03325, with the
/// weights of the options; location, with weight 1, and the last three terms are ours.
/// @param sharpening second phase, in which `confidence` counts
torch::Tensor conceptLoss(const ConceptTerms& terms, const ConceptTrainingOptions& options,
                          bool sharpening);

}  // namespace conceptplan
