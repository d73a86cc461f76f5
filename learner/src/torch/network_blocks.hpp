#pragma once

#include <torch/torch.h>

#include <cmath>

#include "conceptplan/learner/torch/concept_network.hpp"

namespace conceptplan::network {

namespace nn = torch::nn;

inline nn::Conv2d convolution(std::int64_t in, std::int64_t out, std::int64_t kernel,
                              std::int64_t stride) {
  return nn::Conv2d(nn::Conv2dOptions(in, out, kernel).stride(stride).padding((kernel - 1) / 2));
}

inline nn::ConvTranspose2d transposedConvolution(std::int64_t in, std::int64_t out,
                                                 std::int64_t stride) {
  return nn::ConvTranspose2d(
      nn::ConvTranspose2dOptions(in, out, stride == 1 ? 3 : 4).stride(stride).padding(1));
}

inline nn::GroupNorm normalization(std::int64_t channels) {
  return nn::GroupNorm(nn::GroupNormOptions(8, channels));
}

/// Red, green, blue, mask, depth.
inline constexpr std::int64_t kDrawnChannels = 5;

/// What a network draws, [B, 5, E, E], as an object.
inline DecodedObject decodedObject(const torch::Tensor& drawn) {
  return {torch::sigmoid(drawn.slice(1, 0, 3)), drawn.slice(1, 3, 4),
          torch::sigmoid(drawn.slice(1, 4, 5))};
}

/// x + conv(relu(norm(conv(relu(norm(x)))))). [B, C, H, W] -> [B, C, H, W].
class ResidualBlockImpl : public nn::Module {
 public:
  explicit ResidualBlockImpl(std::int64_t channels)
      : body_(register_module(
            "body", nn::Sequential(normalization(channels), nn::ReLU(),
                                   convolution(channels, channels, 3, 1), normalization(channels),
                                   nn::ReLU(), convolution(channels, channels, 3, 1)))) {}

  torch::Tensor forward(const torch::Tensor& x) { return x + body_->forward(x); }

 private:
  nn::Sequential body_;
};
TORCH_MODULE(ResidualBlock);

/// Convolution and pixel shuffle. [B, in, H, W] -> [B, out, 2H, 2W].
class UpsamplingImpl : public nn::Module {
 public:
  UpsamplingImpl(std::int64_t in, std::int64_t out)
      : convolution_(register_module("convolution", convolution(in, 4 * out, 3, 1))) {}

  torch::Tensor forward(const torch::Tensor& x) { return torch::pixel_shuffle(convolution_(x), 2); }

 private:
  nn::Conv2d convolution_;
};
TORCH_MODULE(Upsampling);

/// Queries cross-attend to context tokens, then each passes a perceptron; queries never attend to
/// each other. Source: Visual Concepts Tokenization, arXiv 2205.10093.
class CrossAttentionLayerImpl : public nn::Module {
 public:
  CrossAttentionLayerImpl()
      : query_norm_(register_module("query_norm", layerNorm())),
        image_norm_(register_module("image_norm", layerNorm())),
        query_(register_module("query", nn::Linear(kTokenWidth, kTokenWidth))),
        key_(register_module("key", nn::Linear(kTokenWidth, kTokenWidth))),
        value_(register_module("value", nn::Linear(kTokenWidth, kTokenWidth))),
        out_(register_module("out", nn::Linear(kTokenWidth, kTokenWidth))),
        perceptron_(register_module(
            "perceptron", nn::Sequential(layerNorm(), nn::Linear(kTokenWidth, 2 * kTokenWidth),
                                         nn::GELU(), nn::Linear(2 * kTokenWidth, kTokenWidth)))) {}

  /// queries [B, Q, 64], context [B, N, 64] -> [B, Q, 64].
  torch::Tensor forward(const torch::Tensor& queries, const torch::Tensor& context) {
    const auto keys_from = image_norm_(context);
    const auto q = heads(query_(query_norm_(queries)));
    const auto k = heads(key_(keys_from));
    const auto v = heads(value_(keys_from));
    const double scale = 1.0 / std::sqrt(static_cast<double>(kTokenWidth / kHeads));
    const auto attention = torch::softmax(torch::matmul(q, k.transpose(-2, -1)) * scale, -1);
    const auto mixed = torch::matmul(attention, v).transpose(1, 2).reshape(queries.sizes());
    const auto attended = queries + out_(mixed);
    return attended + perceptron_->forward(attended);
  }

 private:
  static constexpr std::int64_t kHeads = 4;

  static nn::LayerNorm layerNorm() { return nn::LayerNorm(nn::LayerNormOptions({kTokenWidth})); }

  static torch::Tensor heads(const torch::Tensor& x) {
    return x.view({x.size(0), x.size(1), kHeads, kTokenWidth / kHeads}).transpose(1, 2);
  }

  nn::LayerNorm query_norm_, image_norm_;
  nn::Linear query_, key_, value_, out_;
  nn::Sequential perceptron_;
};
TORCH_MODULE(CrossAttentionLayer);

}  // namespace conceptplan::network
