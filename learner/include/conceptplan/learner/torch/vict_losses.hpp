#pragma once

#include <torch/torch.h>

namespace conceptplan {

/// Mean squared errors of one step; the terms of Eq. (8) of arXiv 2310.03325.
struct VictLosses {
  double tokens = 0;          ///< L_MSE(C1', C1)
  double prediction = 0;      ///< L_MSE(X~1, X1), within windows
  double reconstruction = 0;  ///< L_MSE(X0', X0), within windows
};

/// The first term, which the causal transition learns from. predicted, truth [B, 6, 64] -> scalar.
torch::Tensor tokenLoss(const torch::Tensor& predicted, const torch::Tensor& truth);

/// What the frame synthesizer learns from: ten times the mean squared error of all windows, so that
/// the second and the third term weigh as many as they have windows, and once the mean absolute
/// error, which is ours and keeps edges sharp. frames, truth [B, 3, E, E] in 0..1 -> scalar.
torch::Tensor synthesisLoss(const torch::Tensor& frames, const torch::Tensor& truth);

/// The second and the third term by themselves; one without windows is 0.
/// reconstruction [B, 1, 1, 1]: 1 for a window that shows its own frame, 0 for one of another.
VictLosses synthesisErrors(const torch::Tensor& frames, const torch::Tensor& truth,
                           const torch::Tensor& reconstruction);

}  // namespace conceptplan
