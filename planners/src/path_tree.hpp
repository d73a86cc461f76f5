#pragma once

#include <cstdint>
#include <vector>

#include "successors.hpp"

namespace conceptplan {

/// Action sequences that share their beginnings.
class PathTree {
 public:
  struct Node {
    std::uint32_t parent;  ///< its own number at the root
    StateId state;
    PathCost cost;         ///< from the root
    std::uint32_t length;  ///< actions from the root
    Action action;         ///< the last one; no meaning at the root
  };

  explicit PathTree(StateId root) : nodes_{{0, root, 0, 0, Action::kMoveFront}} {}

  /// Adds a step to the sequence that ends in `parent`; gives its number.
  std::uint32_t add(std::uint32_t parent, const Successor& step);

  const Node& operator[](std::uint32_t number) const { return nodes_[number]; }

  /// From the root to the node.
  StatePath path(std::uint32_t number) const;

 private:
  std::vector<Node> nodes_;
};

}  // namespace conceptplan
