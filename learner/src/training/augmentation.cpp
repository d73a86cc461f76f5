#include "conceptplan/learner/training/augmentation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace conceptplan {
namespace {

constexpr int kEdge = EncoderInput::kEdge;
constexpr int kPixels = EncoderInput::kPixels;
constexpr double kLeastVisible = 0.4;

double uniform(std::mt19937_64& generator, double low, double high) {
  return low + (high - low) * (static_cast<double>(generator() >> 11) * 0x1.0p-53);
}

int uniformInt(std::mt19937_64& generator, int low, int high) {
  return low + static_cast<int>(generator() % static_cast<std::uint64_t>(high - low + 1));
}

/// Sum of three uniform draws, close to a normal one of unit variance.
double nearlyNormal(std::mt19937_64& generator) {
  return 2.0 * (uniform(generator, -0.5, 0.5) + uniform(generator, -0.5, 0.5) +
                uniform(generator, -0.5, 0.5));
}

std::uint8_t toByte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

void erase(EncoderInput& input, int pixel) {
  for (int channel = 0; channel < EncoderInput::kChannels; ++channel)
    input.planes[channel * kPixels + pixel] = 0;
}

/// Hides what an object one row nearer to the camera would hide. Nothing if too little remained.
void occlude(EncoderInput& input, std::span<const std::uint8_t> occluder,
             std::mt19937_64& generator) {
  const bool diagonal = uniform(generator, 0, 1) < 0.3;
  const int side = uniform(generator, 0, 1) < 0.5 ? -1 : 1;
  const int dx = diagonal ? side * uniformInt(generator, 32, 52) : uniformInt(generator, -6, 6);
  const int dy = uniformInt(generator, 24, 46);
  std::vector<int> hidden;
  int visible = 0;
  for (int y = 0; y < kEdge; ++y)
    for (int x = 0; x < kEdge; ++x) {
      const int pixel = y * kEdge + x;
      if (input.planes[EncoderInput::kMaskPlane * kPixels + pixel] == 0) continue;
      const int from_x = x - dx, from_y = y - dy;
      const bool covered =
          from_x >= 0 && from_x < kEdge && from_y >= 0 && from_y < kEdge &&
          occluder[EncoderInput::kMaskPlane * kPixels + from_y * kEdge + from_x] != 0;
      if (covered)
        hidden.push_back(pixel);
      else
        ++visible;
    }
  if (visible < kLeastVisible * static_cast<double>(visible + static_cast<int>(hidden.size())))
    return;
  for (const int pixel : hidden) erase(input, pixel);
}

/// Takes from the object half of the pixels along its outline, as an inexact mask would.
void fray(EncoderInput& input, std::mt19937_64& generator) {
  const auto outside = [&](int x, int y) {
    return x < 0 || x >= kEdge || y < 0 || y >= kEdge ||
           input.planes[EncoderInput::kMaskPlane * kPixels + y * kEdge + x] == 0;
  };
  std::vector<int> lost;
  for (int y = 0; y < kEdge; ++y)
    for (int x = 0; x < kEdge; ++x)
      if (!outside(x, y) &&
          (outside(x - 1, y) || outside(x + 1, y) || outside(x, y - 1) || outside(x, y + 1)) &&
          uniform(generator, 0, 1) < 0.5)
        lost.push_back(y * kEdge + x);
  for (const int pixel : lost) erase(input, pixel);
}

/// Moves the picture so that the bounding box of the mask is centred, off by (error_x, error_y).
void recentre(EncoderInput& input, int error_x, int error_y) {
  int left = kEdge, right = -1, top = kEdge, bottom = -1;
  for (int y = 0; y < kEdge; ++y)
    for (int x = 0; x < kEdge; ++x)
      if (input.planes[EncoderInput::kMaskPlane * kPixels + y * kEdge + x] != 0) {
        left = std::min(left, x), right = std::max(right, x);
        top = std::min(top, y), bottom = std::max(bottom, y);
      }
  if (right < 0) return;
  const int dx = (left + right + 1) / 2 - kEdge / 2 + error_x;
  const int dy = (top + bottom + 1) / 2 - kEdge / 2 + error_y;
  if (dx == 0 && dy == 0) return;
  std::vector<std::uint8_t> moved(input.planes.size(), 0);
  for (int channel = 0; channel < EncoderInput::kChannels; ++channel)
    for (int y = std::max(0, -dy); y < std::min(kEdge, kEdge - dy); ++y)
      for (int x = std::max(0, -dx); x < std::min(kEdge, kEdge - dx); ++x)
        moved[channel * kPixels + y * kEdge + x] =
            input.planes[channel * kPixels + (y + dy) * kEdge + x + dx];
  input.planes = std::move(moved);
  input.location[0] += static_cast<float>(dx) / (kFrameWidth / 2.0F);
  input.location[1] += static_cast<float>(dy) / (kFrameHeight / 2.0F);
}

/// Measures depth from the median of what is visible.
void recentreDepth(EncoderInput& input) {
  std::array<int, 256> histogram{};
  int visible = 0;
  for (int i = 0; i < kPixels; ++i)
    if (input.planes[EncoderInput::kMaskPlane * kPixels + i] != 0) {
      ++histogram[input.planes[EncoderInput::kDepthPlane * kPixels + i]];
      ++visible;
    }
  int median = 0, below = histogram[0];
  while (below <= visible / 2 && median < 255) below += histogram[++median];
  const int change = median - 128;
  if (visible == 0 || change == 0) return;
  for (int i = 0; i < kPixels; ++i)
    if (input.planes[EncoderInput::kMaskPlane * kPixels + i] != 0) {
      auto& depth = input.planes[EncoderInput::kDepthPlane * kPixels + i];
      depth = static_cast<std::uint8_t>(std::clamp(depth - change, 1, 255));
    }
  input.location[2] += 0.002F * static_cast<float>(change);
}

void relight(EncoderInput& input, const AugmentationOptions& options, std::mt19937_64& generator) {
  const double gain = 1 + uniform(generator, -options.gain, options.gain);
  const double sigma = uniform(generator, 0, options.noise);
  const bool shaded = uniform(generator, 0, 1) < options.shadow;
  const double angle = uniform(generator, 0, 2 * std::numbers::pi);
  const double along_x = std::cos(angle), along_y = std::sin(angle);
  const double offset = uniform(generator, -12, 12);
  const double shade = uniform(generator, 0.6, 0.9);
  for (int channel = 0; channel < 3; ++channel) {
    const double factor =
        gain * (1 + uniform(generator, -options.channel_gain, options.channel_gain));
    for (int i = 0; i < kPixels; ++i) {
      if (input.planes[EncoderInput::kMaskPlane * kPixels + i] == 0) continue;
      const double along =
          along_x * (i % kEdge - kEdge / 2) + along_y * (i / kEdge - kEdge / 2) - offset;
      auto& value = input.planes[channel * kPixels + i];
      value = toByte(value * factor * (shaded && along > 0 ? shade : 1.0) +
                     sigma * nearlyNormal(generator));
    }
  }
}

}  // namespace

EncoderInput augmented(std::span<const std::uint8_t> planes, const std::array<float, 3>& location,
                       std::span<const std::uint8_t> occluder, const AugmentationOptions& options,
                       std::mt19937_64& generator) {
  EncoderInput input{{planes.begin(), planes.end()}, location};
  if (uniform(generator, 0, 1) < options.occlusion) {
    occlude(input, occluder, generator);
    recentreDepth(input);
  }
  if (uniform(generator, 0, 1) < options.mask_noise) fray(input, generator);
  recentre(input, uniformInt(generator, -options.shift_px, options.shift_px),
           uniformInt(generator, -options.shift_px, options.shift_px));
  relight(input, options, generator);
  return input;
}

}  // namespace conceptplan
