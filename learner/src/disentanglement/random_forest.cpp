#include "disentanglement/random_forest.hpp"

#include <bitset>
#include <numeric>
#include <utility>

namespace conceptplan {
namespace {

struct Split {
  double decrease = 0;  ///< of the Gini impurity times the rows
  Eigen::Index dimension = 0;
  int highest_left = 0;
};

/// Finds the splits of nodes; keeps its histogram between them.
class SplitSearch {
 public:
  SplitSearch(const QuantileBins& bins, const Eigen::VectorXi& labels, int classes)
      : bins_(bins), labels_(labels), histogram_(classes, kQuantileBins) {
    histogram_.setZero();
  }

  /// The best split of the rows at one dimension, if it is better than `best`.
  /// @param counts of the rows' classes
  void improve(Split& best, Eigen::Index dimension, const std::vector<Eigen::Index>& rows,
               const Eigen::VectorXd& counts) {
    std::bitset<kQuantileBins> used;
    for (const Eigen::Index row : rows) {
      const std::uint8_t bin = bins_(row, dimension);
      histogram_(labels_[row], bin) += 1;
      used.set(bin);
    }
    // n times the Gini impurity is n less the sum of squared counts over n.
    const double n = counts.sum(), squares = counts.squaredNorm();
    double left = 0, left_squares = 0, right_squares = squares;
    left_counts_.setZero(counts.size());
    for (int bin = 0; bin < kQuantileBins; ++bin) {
      if (!used[static_cast<std::size_t>(bin)]) continue;
      for (Eigen::Index c = 0; c < counts.size(); ++c) {
        const double moved = histogram_(c, bin);
        if (moved == 0) continue;
        left_squares += moved * (2 * left_counts_[c] + moved);
        right_squares -= moved * (2 * (counts[c] - left_counts_[c]) - moved);
        left_counts_[c] += moved;
        left += moved;
      }
      histogram_.col(bin).setZero();
      if (left == n) break;
      const double decrease = left_squares / left + right_squares / (n - left) - squares / n;
      if (decrease > best.decrease * (1 + 1e-9) + 1e-9) best = {decrease, dimension, bin};
    }
  }

 private:
  const QuantileBins& bins_;
  const Eigen::VectorXi& labels_;
  Eigen::MatrixXd histogram_;  // [classes, bins], zeros between calls
  Eigen::VectorXd left_counts_;
};

}  // namespace

RandomForest::RandomForest(const QuantileBins& bins, const Eigen::VectorXi& labels, int classes,
                           const std::vector<Eigen::Index>& rows, std::mt19937_64& generator)
    : classes_(classes), dimensions_(bins.cols()) {
  for (int tree = 0; tree < kTrees; ++tree) {
    std::vector<Eigen::Index> drawn(rows.size());
    for (Eigen::Index& row : drawn) row = rows[generator() % rows.size()];
    trees_.push_back(grow(bins, labels, std::move(drawn), generator));
  }
}

RandomForest::Tree RandomForest::grow(const QuantileBins& bins, const Eigen::VectorXi& labels,
                                      std::vector<Eigen::Index> rows,
                                      std::mt19937_64& generator) const {
  const auto all = static_cast<double>(rows.size());
  SplitSearch search(bins, labels, classes_);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(dimensions_));
  std::iota(order.begin(), order.end(), 0);
  Tree tree(1);
  std::vector<std::vector<Eigen::Index>> rows_of{std::move(rows)};
  for (std::size_t at = 0; at < tree.size(); ++at) {
    const std::vector<Eigen::Index> here = std::move(rows_of[at]);
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(classes_);
    for (const Eigen::Index row : here) counts[labels[row]] += 1;
    tree[at].shares = (counts / counts.sum()).cast<float>();
    const int depth = tree[at].depth;
    if (depth == kMaxDepth || counts.maxCoeff() == counts.sum()) continue;
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[generator() % i]);
    Split split;
    for (const Eigen::Index dimension : order) search.improve(split, dimension, here, counts);
    if (!(split.decrease > 0)) continue;
    tree[at].decrease = split.decrease / all;
    tree[at].dimension = split.dimension;
    tree[at].highest_left = split.highest_left;
    tree[at].left = static_cast<int>(tree.size());
    rows_of.resize(rows_of.size() + 2);
    for (const Eigen::Index row : here)
      rows_of[tree.size() + (bins(row, split.dimension) > split.highest_left ? 1 : 0)].push_back(
          row);
    tree.resize(tree.size() + 2);
    tree.end()[-1].depth = tree.end()[-2].depth = depth + 1;
  }
  return tree;
}

int RandomForest::predict(const QuantileBins& bins, Eigen::Index row, int depth) const {
  Eigen::VectorXf votes = Eigen::VectorXf::Zero(classes_);
  for (const Tree& tree : trees_) {
    const Node* node = &tree.front();
    while (node->left >= 0 && node->depth < depth)
      node = &tree[static_cast<std::size_t>(
          node->left + (bins(row, node->dimension) > node->highest_left ? 1 : 0))];
    votes += node->shares;
  }
  Eigen::Index best = 0;
  votes.maxCoeff(&best);
  return static_cast<int>(best);
}

Eigen::VectorXd RandomForest::importance(int depth) const {
  Eigen::VectorXd importance = Eigen::VectorXd::Zero(dimensions_);
  for (const Tree& tree : trees_)
    for (const Node& node : tree)
      if (node.left >= 0 && node.depth < depth) importance[node.dimension] += node.decrease;
  const double total = importance.sum();
  return total > 0 ? (importance / total).eval() : importance;
}

}  // namespace conceptplan
