#include "path_tree.hpp"

#include <algorithm>

namespace conceptplan {

std::uint32_t PathTree::add(std::uint32_t parent, const Successor& step) {
  const Node& before = nodes_[parent];
  nodes_.push_back({parent, step.state, before.cost + step.cost, before.length + 1, step.action});
  return static_cast<std::uint32_t>(nodes_.size() - 1);
}

StatePath PathTree::path(std::uint32_t number) const {
  StatePath path;
  path.cost = nodes_[number].cost;
  for (; nodes_[number].length > 0; number = nodes_[number].parent) {
    path.actions.push_back(nodes_[number].action);
    path.states.push_back(nodes_[number].state);
  }
  std::reverse(path.actions.begin(), path.actions.end());
  std::reverse(path.states.begin(), path.states.end());
  return path;
}

}  // namespace conceptplan
