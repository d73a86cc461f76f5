#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "disentanglement/quantile_bins.hpp"

namespace conceptplan {

/// Bagged classification trees by Gini impurity; a split may use any dimension, equal ones are
/// chosen between at random. Trees are grown whole and may be read as if they ended at a depth.
/// Source: Breiman, Random Forests, Machine Learning 45, 2001.
class RandomForest {
 public:
  static constexpr int kTrees = 10;
  static constexpr int kMaxDepth = 12;

  /// @param bins [N, D] @param labels [N], in [0, classes) @param rows those to learn from
  RandomForest(const QuantileBins& bins, const Eigen::VectorXi& labels, int classes,
               const std::vector<Eigen::Index>& rows, std::mt19937_64& generator);

  /// The most probable class of a picture by trees that end at the depth.
  int predict(const QuantileBins& bins, Eigen::Index row, int depth) const;

  /// Share of each dimension in the decrease of impurity down to the depth, [D]; zeros if no split
  /// helps.
  Eigen::VectorXd importance(int depth) const;

 private:
  struct Node {
    Eigen::VectorXf shares;  ///< of the classes
    int depth = 0;
    double decrease = 0;         ///< of impurity by the split, relative to all rows
    Eigen::Index dimension = 0;  ///< of the split
    int highest_left = 0;        ///< bin
    int left = -1;               ///< child, -1 if a leaf; the right one follows it
  };
  using Tree = std::vector<Node>;

  Tree grow(const QuantileBins& bins, const Eigen::VectorXi& labels, std::vector<Eigen::Index> rows,
            std::mt19937_64& generator) const;

  int classes_;
  Eigen::Index dimensions_;
  std::vector<Tree> trees_;
};

}  // namespace conceptplan
