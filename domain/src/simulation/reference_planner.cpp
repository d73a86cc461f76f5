#include "conceptplan/domain/simulation/reference_planner.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <vector>

#include "conceptplan/domain/simulation/simulator.hpp"

namespace conceptplan {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// A state of the target that the search has reached.
struct Node {
  ObjectState state;
  int depth;
  std::uint64_t num_paths;  ///< shortest ones from the start
  std::size_t first_edge;   ///< the last edge found that leads here
};

struct Edge {
  std::size_t from;  ///< a node
  Action action;
  std::size_t next;  ///< another edge that leads to the same node
};

class Search {
 public:
  explicit Search(const World& world)
      : world_(world),
        node_of_(static_cast<std::size_t>(world.workbench.columns * world.workbench.rows) * 24,
                 kNone) {
    reach(world.objects[world.target], 0);
    nodes_[0].num_paths = 1;
  }

  /// All nodes of one depth precede those of the next, so the paths to a node are counted when
  /// its turn comes.
  std::optional<std::size_t> find(const ObjectState& goal) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].state == goal) return i;
      expand(i);
    }
    return std::nullopt;
  }

  ActionSequence drawPlan(std::size_t last, RandomStream& random) const {
    ActionSequence plan;
    for (std::size_t i = last; i != 0;) {
      std::size_t draw = random.below(nodes_[i].num_paths);
      std::size_t edge = nodes_[i].first_edge;
      while (draw >= nodes_[edges_[edge].from].num_paths) {
        draw -= nodes_[edges_[edge].from].num_paths;
        edge = edges_[edge].next;
      }
      plan.push_back(edges_[edge].action);
      i = edges_[edge].from;
    }
    std::reverse(plan.begin(), plan.end());
    return plan;
  }

 private:
  void expand(std::size_t i) {
    const ObjectState from = nodes_[i].state;
    for (const Action action : kActions) {
      world_.objects[world_.target] = from;
      if (advance(world_, action)) continue;
      Node& successor = nodes_[reach(world_.objects[world_.target], nodes_[i].depth + 1)];
      if (successor.depth != nodes_[i].depth + 1) continue;
      successor.num_paths += nodes_[i].num_paths;
      edges_.push_back({i, action, successor.first_edge});
      successor.first_edge = edges_.size() - 1;
    }
  }

  std::size_t reach(const ObjectState& state, int depth) {
    const int cell = state.cell.y * world_.workbench.columns + state.cell.x;
    std::size_t& node =
        node_of_.at(static_cast<std::size_t>((cell * 4 + state.rotation) * 6 + state.color));
    if (node == kNone) {
      node = nodes_.size();
      nodes_.push_back({state, depth, 0, kNone});
    }
    return node;
  }

  World world_;
  std::vector<std::size_t> node_of_;
  std::vector<Node> nodes_;
  std::vector<Edge> edges_;
};

/// Breadth-first search over the states of several targets.
class JointSearch {
 public:
  explicit JointSearch(const Task& task) : world_(task.initial) {
    std::vector<ObjectState> start, goal;
    for (const FurtherTarget& target : targetsOf(task)) {
      objects_.push_back(target.object);
      start.push_back(world_.objects.at(target.object));
      goal.push_back(target.goal);
      reachable_ = reachable_ && target.goal.type == start.back().type &&
                   target.goal.size == start.back().size;
    }
    goal_ = pack(goal);
    reach(pack(start), {});
  }

  std::optional<JointSequence> find() {
    for (std::size_t i = 0; reachable_ && i < nodes_.size(); ++i) {
      if (nodes_[i].state == goal_) return sequenceTo(i);
      expand(i);
    }
    return std::nullopt;
  }

 private:
  struct Node {
    std::uint64_t state = 0;
    std::size_t parent = 0;
    std::size_t moved = 0;
    Action action{};
  };

  /// What changes of the targets; the cells of all of them fit 64 bits for up to seven.
  std::uint64_t pack(const std::vector<ObjectState>& targets) const {
    std::uint64_t packed = 0;
    for (const ObjectState& target : targets) {
      const int cell = target.cell.y * world_.workbench.columns + target.cell.x;
      packed = packed * numStates() +
               static_cast<std::uint64_t>((cell * 4 + target.rotation) * 6 + target.color);
    }
    return packed;
  }

  std::uint64_t numStates() const {
    return static_cast<std::uint64_t>(world_.workbench.columns * world_.workbench.rows) * 24;
  }

  void unpack(std::uint64_t packed) {
    for (std::size_t i = objects_.size(); i-- > 0;) {
      const int state = static_cast<int>(packed % numStates());
      packed /= numStates();
      ObjectState& target = world_.objects[objects_[i]];
      target.color = state % 6;
      target.rotation = state / 6 % 4;
      target.cell = {state / 24 % world_.workbench.columns, state / 24 / world_.workbench.columns};
    }
  }

  void expand(std::size_t i) {
    std::vector<ObjectState> targets(objects_.size());
    for (const std::size_t moved : objects_) {
      for (const Action action : kActions) {
        unpack(nodes_[i].state);
        world_.target = moved;
        if (advance(world_, action)) continue;
        for (std::size_t t = 0; t < targets.size(); ++t) targets[t] = world_.objects[objects_[t]];
        reach(pack(targets), {0, i, moved, action});
      }
    }
  }

  void reach(std::uint64_t state, Node node) {
    if (!seen_.insert(state).second) return;
    node.state = state;
    nodes_.push_back(node);
  }

  JointSequence sequenceTo(std::size_t node) const {
    JointSequence sequence;
    for (; node != 0; node = nodes_[node].parent) {
      sequence.actions.push_back(nodes_[node].action);
      sequence.moved.push_back(nodes_[node].moved);
    }
    std::reverse(sequence.actions.begin(), sequence.actions.end());
    std::reverse(sequence.moved.begin(), sequence.moved.end());
    return sequence;
  }

  World world_;
  std::vector<std::size_t> objects_;
  bool reachable_ = true;  // types and sizes never change
  std::uint64_t goal_ = 0;
  std::vector<Node> nodes_;
  std::unordered_set<std::uint64_t> seen_;
};

}  // namespace

std::optional<JointSequence> shortestJointPlan(const Task& task) {
  return JointSearch(task).find();
}

std::optional<ActionSequence> shortestPlan(const World& world, const ObjectState& goal,
                                           RandomStream& random) {
  if (world.target >= world.objects.size())
    throw std::invalid_argument("target " + std::to_string(world.target) + " of a world of " +
                                std::to_string(world.objects.size()) + " objects");
  Search search(world);
  const std::optional<std::size_t> last = search.find(goal);
  if (!last) return std::nullopt;
  return search.drawPlan(*last, random);
}

}  // namespace conceptplan
