#pragma once

#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "conceptplan/planners/symbol_graph.hpp"

namespace conceptplan {

/// What leads to each state: edges grouped by their member `to`, in their order.
template <typename Edge>
class GroupedByEnd {
 public:
  GroupedByEnd(std::size_t num_states, std::span<const Edge> edges)
      : first_(num_states + 1, 0), edges_(edges.size()) {
    for (const Edge& edge : edges) ++first_[index(edge.to) + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    std::vector<std::size_t> free(first_.begin(), first_.end() - 1);
    for (const Edge& edge : edges) edges_[free[index(edge.to)]++] = edge;
  }

  std::span<const Edge> operator[](StateId end) const {
    return std::span(edges_).subspan(first_[index(end)],
                                     first_[index(end) + 1] - first_[index(end)]);
  }

 private:
  std::vector<std::size_t> first_;  // [states + 1]
  std::vector<Edge> edges_;
};

}  // namespace conceptplan
