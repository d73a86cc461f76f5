#include "disentanglement/quantile_bins.hpp"

#include <algorithm>
#include <vector>

namespace conceptplan {

QuantileBins quantileBins(const Eigen::MatrixXd& codes) {
  QuantileBins bins(codes.rows(), codes.cols());
  for (Eigen::Index d = 0; d < codes.cols(); ++d) {
    std::vector<double> sorted(codes.col(d).begin(), codes.col(d).end());
    std::sort(sorted.begin(), sorted.end());
    std::vector<double> uppers;  // largest code of each bin but the last
    for (std::size_t b = 1; b < kQuantileBins; ++b)
      uppers.push_back(sorted[b * (sorted.size() - 1) / kQuantileBins]);
    uppers.erase(std::unique(uppers.begin(), uppers.end()), uppers.end());
    for (Eigen::Index i = 0; i < codes.rows(); ++i)
      bins(i, d) = static_cast<std::uint8_t>(
          std::lower_bound(uppers.begin(), uppers.end(), codes(i, d)) - uppers.begin());
  }
  return bins;
}

}  // namespace conceptplan
