#pragma once

#include "conceptplan/domain/image.hpp"

namespace conceptplan {

/// Peak signal-to-noise ratio of the colours of two pictures, dB: 10 log10(255^2 / mean squared
/// error) over all pixels and channels; infinity if they are equal.
/// @throws std::invalid_argument if their sizes differ.
double peakSignalToNoise_dB(const RgbdImage& a, const RgbdImage& b);

/// Structural similarity of two pictures, at most 1: the mean over all windows of 11 x 11 pixels
/// within the picture, weighted by a Gaussian of sigma 1.5, of SSIM on luma (ITU-R BT.601), with
/// K1 = 0.01 and K2 = 0.03. Source: Wang et al., IEEE Trans. Image Processing 13(4), 2004, Eq.
/// (13).
/// @throws std::invalid_argument if their sizes differ or are smaller than a window.
double structuralSimilarity(const RgbdImage& a, const RgbdImage& b);

}  // namespace conceptplan
