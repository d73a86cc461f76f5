#pragma once

#include <torch/torch.h>

#include <cstdint>

namespace conceptplan {

/// Colour, mask and relative depth of an object, as it is drawn from tokens; E is 64 for a crop,
/// 256 for a whole frame.
struct DecodedObject {
  torch::Tensor rgb;          ///< [B, 3, E, E], 0 to 1
  torch::Tensor mask_logits;  ///< [B, 1, E, E]
  torch::Tensor depth;        ///< [B, 1, E, E], 0 to 1, as the depth plane of `EncoderInput`
};

/// Where each object lies in its crop: the middle of its bounding box and half of its extents, in
/// units in which the crop spans -1 to 1. mask [B, 1, 64, 64], above 0.5 on the object -> [B, 4],
/// x, y, width, height. An empty mask gives no meaningful box.
torch::Tensor boundingBoxes(const torch::Tensor& mask);

/// Draws objects sharply from concept tokens: a perceptron mixes learned pictures of 48 x 48 that
/// are filled by the object, convolutions refine the mixture, and it is then put into the box that
/// a second perceptron reads from the tokens. So neither has to know the other's business: what the
/// object looks like, and how large and where it is seen. The box follows spatial transformer
/// networks, Jaderberg et al., NIPS 2015 (arXiv 1506.02025).
class ObjectDrawerImpl : public torch::nn::Module {
 public:
  ObjectDrawerImpl();

  /// tokens [B, 6, 64], boxes [B, 4] as of `boundingBoxes` -> the objects in their crops of 64
  /// x 64.
  DecodedObject forward(const torch::Tensor& tokens, const torch::Tensor& boxes);

  /// tokens [B, 6, 64] -> [B, 4] as of `boundingBoxes`.
  torch::Tensor locateInCrop(const torch::Tensor& tokens);

 private:
  torch::nn::Sequential mixture_{nullptr}, refinement_{nullptr}, box_{nullptr};
};
TORCH_MODULE(ObjectDrawer);

}  // namespace conceptplan
