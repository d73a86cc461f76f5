#include "conceptplan/domain/image_quality.hpp"

#include <Eigen/Core>
#include <cmath>
#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

constexpr Eigen::Index kWindow = 11;
constexpr double kSigma = 1.5;
constexpr double kPeak = 255;

using Plane = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void checkSameSize(const RgbdImage& a, const RgbdImage& b) {
  if (a.width != b.width || a.height != b.height || a.rgb.size() != b.rgb.size() || a.rgb.empty())
    throw std::invalid_argument("pictures of " + std::to_string(a.width) + " x " +
                                std::to_string(a.height) + " and " + std::to_string(b.width) +
                                " x " + std::to_string(b.height) + " cannot be compared");
}

Plane luma(const RgbdImage& image) {
  Plane plane(image.height, image.width);
  for (Eigen::Index i = 0; i < plane.size(); ++i) {
    const auto* pixel = &image.rgb[static_cast<std::size_t>(3 * i)];
    plane.data()[i] = 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2];
  }
  return plane;
}

/// Weighted means over all windows that lie within the plane.
Plane windowMeans(const Plane& plane) {
  Eigen::Array<double, kWindow, 1> weight;
  for (Eigen::Index i = 0; i < kWindow; ++i) {
    const auto offset = static_cast<double>(i - kWindow / 2);
    weight[i] = std::exp(-offset * offset / (2 * kSigma * kSigma));
  }
  weight /= weight.sum();
  Plane along_rows = Plane::Zero(plane.rows(), plane.cols() - kWindow + 1);
  for (Eigen::Index i = 0; i < kWindow; ++i)
    along_rows += weight[i] * plane.middleCols(i, along_rows.cols());
  Plane means = Plane::Zero(plane.rows() - kWindow + 1, along_rows.cols());
  for (Eigen::Index i = 0; i < kWindow; ++i)
    means += weight[i] * along_rows.middleRows(i, means.rows());
  return means;
}

}  // namespace

double peakSignalToNoise_dB(const RgbdImage& a, const RgbdImage& b) {
  checkSameSize(a, b);
  double squares = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) {
    const double difference = static_cast<double>(a.rgb[i]) - b.rgb[i];
    squares += difference * difference;
  }
  return 10 * std::log10(kPeak * kPeak * static_cast<double>(a.rgb.size()) / squares);
}

double structuralSimilarity(const RgbdImage& a, const RgbdImage& b) {
  checkSameSize(a, b);
  if (a.width < kWindow || a.height < kWindow)
    throw std::invalid_argument("structuralSimilarity: the pictures are smaller than a window");
  constexpr double c1 = (0.01 * kPeak) * (0.01 * kPeak), c2 = (0.03 * kPeak) * (0.03 * kPeak);
  const Plane x = luma(a), y = luma(b);
  const Plane mean_x = windowMeans(x), mean_y = windowMeans(y);
  const Plane variance_x = windowMeans(x.square()) - mean_x.square();
  const Plane variance_y = windowMeans(y.square()) - mean_y.square();
  const Plane covariance = windowMeans(x * y) - mean_x * mean_y;
  return ((2 * mean_x * mean_y + c1) * (2 * covariance + c2) /
          ((mean_x.square() + mean_y.square() + c1) * (variance_x + variance_y + c2)))
      .mean();
}

}  // namespace conceptplan
