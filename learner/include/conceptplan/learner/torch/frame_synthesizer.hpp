#pragma once

#include <torch/torch.h>

#include <cstdint>

namespace conceptplan {

/// Draws a moved object into a frame without it, window by window: lights the floor where it stood,
/// and adds its picture and shadow. Background encoder and decoder of ViCT, Sec. III-C of arXiv
/// 2310.03325, in one network of three scales with skip connections. Only windows around the old
/// and the new place are drawn; what lies outside stays as it was.
class FrameSynthesizerImpl : public torch::nn::Module {
 public:
  static constexpr std::int64_t kWindow = 96;  ///< edge, pixels

  FrameSynthesizerImpl();

  /// floor [B, 3, 96, 96] in 0..1 and hole [B, 1, 96, 96] as of `Background`;
  /// object [B, 3, 96, 96] and its opacity alpha [B, 1, 96, 96] -> [B, 3, 96, 96] in 0..1.
  torch::Tensor forward(const torch::Tensor& floor, const torch::Tensor& hole,
                        const torch::Tensor& object, const torch::Tensor& alpha);

 private:
  torch::nn::Sequential fine_{nullptr}, middle_{nullptr}, coarse_{nullptr}, deepest_{nullptr};
  torch::nn::Sequential to_middle_{nullptr}, to_fine_{nullptr}, to_frame_{nullptr};
};
TORCH_MODULE(FrameSynthesizer);

}  // namespace conceptplan
