#include "conceptplan/planners/beam_planner.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "conceptplan/planners/path_planning.hpp"
#include "option_range.hpp"
#include "path_tree.hpp"
#include "projection_heuristic.hpp"

namespace conceptplan {
namespace {

constexpr double kWidest = std::numeric_limits<std::int32_t>::max();

/// The end of an action sequence of the current length.
struct Candidate {
  PathCost estimate;
  std::uint32_t node;

  bool operator<(const Candidate& other) const {
    return estimate != other.estimate ? estimate < other.estimate : node < other.node;
  }
};

/// Of the candidates, the best `width`; no state counts more than `top` times over all lengths.
/// Tells whether the width cut some off.
bool keepBest(std::vector<Candidate>& candidates, const PathTree& tree, std::size_t width,
              std::size_t top, std::vector<std::size_t>& visits) {
  std::sort(candidates.begin(), candidates.end());
  std::vector<Candidate> kept;
  bool cut = false;
  for (const Candidate& candidate : candidates) {
    std::size_t& visited = visits[index(tree[candidate.node].state)];
    if (visited >= top) continue;
    if (kept.size() == width) {
      cut = true;
      break;
    }
    ++visited;
    kept.push_back(candidate);
  }
  candidates = std::move(kept);
  return cut;
}

std::vector<StatePath> beamPaths(const PathTask& task, const StateSteps& successors,
                                 std::size_t width) {
  const ProjectionHeuristic heuristic(task.graph, task.goal, successors, &task.guard);
  PathTree tree(task.start);
  std::vector<StatePath> found;
  std::vector<std::size_t> visits(task.graph.numStates(), 0);
  std::vector<Candidate> layer{{0, 0}};
  std::vector<Candidate> longer;
  std::vector<Successor> next;
  bool cut = false;
  for (std::size_t length = 0; !layer.empty() && found.size() < task.query.top; ++length) {
    for (const Candidate& candidate : layer) {
      const StateId state = tree[candidate.node].state;
      if (!task.guard.expand(task.statistics, state)) return found;
      if (state == task.goal) found.push_back(tree.path(candidate.node));
      if (length == task.query.limits.horizon) continue;
      successors(state, next);
      for (const Successor& step : next) {
        const PathCost rest = heuristic(step.state);
        if (rest == kOutOfReach) continue;
        ++task.statistics.generated;
        const std::uint32_t node = tree.add(candidate.node, step);
        longer.push_back({tree[node].cost + rest, node});
      }
    }
    cut = keepBest(longer, tree, width, task.query.top, visits) || cut;
    layer = std::exchange(longer, {});
  }
  if (cut && found.size() < task.query.top) {
    task.guard.stop(PlanStatus::kLimit,
                    "stopped at the width of " + std::to_string(width) + " sequences a length");
  }
  return found;
}

}  // namespace

BeamPlanner::BeamPlanner(const BeamPlannerOptions& options) : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options.step_discount, 0, 0.5);
  checkOptionRange("width", static_cast<double>(options.width), 1, kWidest);
}

PlanResult BeamPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  return planByPaths(graph, query, options_.legality_threshold, [&](const PathTask& task) {
    const StateSteps successors =
        likelySuccessors(graph, options_.legality_threshold, options_.step_discount, &task.guard);
    std::vector<StatePath> paths = beamPaths(task, successors, options_.width);
    std::stable_sort(paths.begin(), paths.end(),
                     [](const StatePath& a, const StatePath& b) { return a.cost < b.cost; });
    if (paths.size() > query.top) paths.resize(query.top);
    return paths;
  });
}

}  // namespace conceptplan
