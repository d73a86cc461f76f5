#include "joint_search.hpp"

#include <algorithm>
#include <queue>
#include <unordered_map>
#include <utility>

namespace conceptplan {
namespace {

using NodeId = std::uint32_t;
constexpr NodeId kNone = static_cast<NodeId>(-1);

/// Numbers the action sequences of one target.
class SequenceNumbers {
 public:
  /// The sequence one action longer than another; 0 is the empty one.
  std::uint32_t longer(std::uint32_t sequence, Action action) {
    return numbers_
        .try_emplace(std::uint64_t{sequence} * kNumActions + index(action), numbers_.size() + 1)
        .first->second;
  }

 private:
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

/// Joint paths that share their beginnings.
struct PathNode {
  JointState state = 0;
  PathRank rank = 0;
  NodeId parent = kNone;
  NodeId expanded_before = kNone;  ///< the node last expanded in the same state
  std::uint32_t length = 0;
  std::uint32_t switches = 0;  ///< steps that move another target than the step before
  JointSuccessor last = {};    ///< the last step; no meaning at the root
};

/// What waits to be expanded; worse is less. Of equally promising paths the longest comes first,
/// since it is nearest to the goal, then the one that turns to other targets least.
struct OpenNode {
  PathRank rank;
  std::uint32_t length;
  std::uint32_t switches;
  NodeId node;

  bool operator<(const OpenNode& other) const {
    if (rank != other.rank) return rank > other.rank;
    if (length != other.length) return length < other.length;
    if (switches != other.switches) return switches > other.switches;
    return node > other.node;
  }
};

class JointSearch {
 public:
  JointSearch(JointSpace& space, const JointSearchOptions& options)
      : space_(space), options_(options) {}

  std::vector<JointPath> run(SearchGuard& guard, SearchStatistics& statistics,
                             std::vector<JointState>& expanded) {
    std::vector<JointPath> found;
    expanded.clear();
    if (bound(space_.start()) == kOutOfReach) return found;
    nodes_.push_back({.state = space_.start()});
    sequences_of_.assign(space_.numTargets(), 0);
    open_.push({0, 0, 0, 0});
    std::vector<JointSuccessor> next;
    while (!open_.empty() && found.size() < options_.top) {
      const NodeId node = open_.top().node;
      open_.pop();
      const JointState state = nodes_[node].state;
      if (isSuperseded(node)) continue;
      if (!guard.expand(statistics)) break;
      const auto [last, is_new] = last_expanded_.try_emplace(state, kNone);
      if (is_new) expanded.push_back(state);
      nodes_[node].expanded_before = std::exchange(last->second, node);
      if (state == space_.goal()) found.push_back(pathTo(node));
      if (nodes_[node].length == options_.horizon) continue;
      space_.successors(state, next);
      for (const JointSuccessor& step : next) {
        if (push(node, step)) ++statistics.generated;
      }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const JointPath& a, const JointPath& b) { return a.cost < b.cost; });
    return found;
  }

 private:
  PathRank bound(JointState state) const { return options_.guided ? space_.bound(state) : 0; }

  std::span<const std::uint32_t> sequences(NodeId node) const {
    return std::span(sequences_of_).subspan(node * space_.numTargets(), space_.numTargets());
  }

  /// Whether no path that goes on from the node can be wanted beside those from the nodes expanded
  /// in its state.
  bool isSuperseded(NodeId node) const {
    const auto last = last_expanded_.find(nodes_[node].state);
    if (last == last_expanded_.end()) return false;
    std::size_t no_longer = 0;
    for (NodeId other = last->second; other != kNone; other = nodes_[other].expanded_before) {
      if (nodes_[other].length > nodes_[node].length) continue;
      if (++no_longer == options_.top) return true;
      if (std::ranges::equal(sequences(other), sequences(node))) return true;
    }
    return false;
  }

  /// Adds one more step to a path; false if nobody wants the longer path.
  bool push(NodeId parent, const JointSuccessor& step) {
    const PathRank rest = bound(step.state);
    if (rest == kOutOfReach) return false;
    const auto node = static_cast<NodeId>(nodes_.size());
    PathNode path{.state = step.state,
                  .rank = std::min(nodes_[parent].rank + rankOf(step.step.cost, 1), kMostRank),
                  .parent = parent,
                  .length = nodes_[parent].length + 1,
                  .switches = nodes_[parent].switches,
                  .last = step};
    if (path.length > 1 && nodes_[parent].last.target != step.target) ++path.switches;
    nodes_.push_back(path);
    sequences_of_.resize(sequences_of_.size() + space_.numTargets());
    for (std::size_t i = 0; i < space_.numTargets(); ++i) {
      const std::uint32_t before = sequences(parent)[i];
      sequences_of_[node * space_.numTargets() + i] =
          i == step.target ? sequence_numbers_.longer(before, step.step.action) : before;
    }
    if (isSuperseded(node)) {
      nodes_.pop_back();
      sequences_of_.resize(sequences_of_.size() - space_.numTargets());
      return false;
    }
    open_.push({options_.greedy ? rest : path.rank + rest, path.length, path.switches, node});
    return true;
  }

  JointPath pathTo(NodeId node) const {
    JointPath path;
    for (; nodes_[node].parent != kNone; node = nodes_[node].parent) {
      path.steps.push_back(nodes_[node].last);
      path.cost += nodes_[node].last.step.cost;
    }
    std::reverse(path.steps.begin(), path.steps.end());
    return path;
  }

  JointSpace& space_;
  JointSearchOptions options_;
  std::vector<PathNode> nodes_;
  std::vector<std::uint32_t> sequences_of_;  // [nodes][targets], the actions of each
  SequenceNumbers sequence_numbers_;         // of all targets
  std::unordered_map<JointState, NodeId> last_expanded_;
  std::priority_queue<OpenNode> open_;
};

}  // namespace

std::vector<JointPath> bestJointPaths(JointSpace& space, const JointSearchOptions& options,
                                      SearchGuard& guard, SearchStatistics& statistics,
                                      std::vector<JointState>& expanded) {
  return JointSearch(space, options).run(guard, statistics, expanded);
}

}  // namespace conceptplan
