#pragma once

#include <Eigen/Core>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace conceptplan {

/// The numbers [0, count) in an order that the generator decides, the same on every platform.
inline std::vector<Eigen::Index> shuffledRows(Eigen::Index count, std::mt19937_64& generator) {
  std::vector<Eigen::Index> rows(static_cast<std::size_t>(count));
  std::iota(rows.begin(), rows.end(), 0);
  for (std::size_t i = rows.size(); i > 1; --i) std::swap(rows[i - 1], rows[generator() % i]);
  return rows;
}

}  // namespace conceptplan
