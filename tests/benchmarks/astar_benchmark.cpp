// A* on a workbench of 1,000 x 1,000 cells, 30 % of them taken: ours and Boost.Graph's, with the
// same heuristic. Items are expansions.
//
// Boost.Graph searches three forms of the problem. `boostOverItsGrid` is the one of its own example
// for a grid with obstacles, astar_maze.cpp: a grid_graph whose taken cells are filtered out.
// `boostOverItsGraph` has the edges ready in a compressed_sparse_row_graph, its most compact graph
// and the fastest to walk. `boostOverOurGraph` makes them by our successor function, as our search
// does, so that both differ in the search alone. Distances, ranks and predecessors are in arrays,
// colours in two bits each; all are allocated in the time measured, as ours are.

#include <benchmark/benchmark.h>

#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/graph/grid_graph.hpp>
#include <boost/graph/two_bit_color_map.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <cmath>

#include "benchmarks/counted_memory.hpp"
#include "benchmarks/one_plan.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "path_search.hpp"
#include "planners/grid_world.hpp"
#include "planners/obstacle_map.hpp"
#include "projection_heuristic.hpp"

namespace conceptplan {
namespace {

constexpr int kSide = 1000;
constexpr double kObstacleShare = 0.3;
constexpr double kLegalityThreshold = 0.01;
constexpr double kStepDiscount = 0.01;

struct LargeBench {
  testing::GridWorld world = testing::gridWorld(kSide, kSide, 1, 0, 1);
  testing::ObstacleMap obstacles{kSide, kSide, kObstacleShare, 2};
  testing::CountedMemory memory;
  SymbolGraph graph = compile(world.model, world.problem, obstacles);
  double graph_MB = memory.held_MB();
  StateId start = graph.mostProbableStart();
  StateId goal = graph.mostProbableGoal();
  StateSteps steps = rankedSuccessors(graph, kLegalityThreshold, kStepDiscount);
  ProjectionHeuristic heuristic{graph, goal, steps};
};

const LargeBench& largeBench() {
  static const LargeBench bench;
  return bench;
}

void report(benchmark::State& state, std::size_t expanded, double peak_MB, double graph_MB,
            PathCost cost) {
  state.SetItemsProcessed(static_cast<std::int64_t>(expanded));
  state.counters["peak_MB"] = peak_MB;
  state.counters["graph_MB"] = graph_MB;
  state.counters["path_cost"] = toNats(cost);
  state.counters["expanded"] =
      static_cast<double>(expanded) / static_cast<double>(state.iterations());
}

/// The search alone, as Boost.Graph's.
void ourAstar(benchmark::State& state) {
  const LargeBench& bench = largeBench();
  SearchStatistics statistics;
  double peak_MB = 0;
  PathCost cost = 0;
  for (auto _ : state) {
    const testing::CountedMemory memory;
    SearchGuard guard(testing::onePlan().limits);
    const auto paths = bestPaths(bench.graph.numStates(), bench.start, bench.goal, bench.steps,
                                 bench.heuristic, {1, testing::kLongestPlan}, guard, statistics);
    if (paths.empty()) {
      state.SkipWithError("no path");
      break;
    }
    cost = paths.front().cost;
    peak_MB = memory.peak_MB();
  }
  report(state, statistics.expanded, peak_MB, bench.graph_MB, cost);
}

/// Heuristic, search, plan and legality trace.
void ourPlanner(benchmark::State& state) {
  const SymbolGraph& graph = largeBench().graph;
  const auto planner = PlannerRegistry::standard().make("astar");
  std::size_t expanded = 0;
  double peak_MB = 0;
  double cost = 0;
  for (auto _ : state) {
    const testing::CountedMemory memory;
    const PlanResult result = planner->solve(graph, testing::onePlan());
    if (!testing::isSolved(result, state)) break;
    expanded += result.statistics.expanded;
    cost = result.plans.front().cost;
    peak_MB = memory.peak_MB();
  }
  report(state, expanded, peak_MB, largeBench().graph_MB, toPathCost(cost));
}

void compileLargeBench(benchmark::State& state) {
  const LargeBench& bench = largeBench();
  double peak_MB = 0;
  for (auto _ : state) {
    const testing::CountedMemory memory;
    benchmark::DoNotOptimize(compile(bench.world.model, bench.world.problem, bench.obstacles));
    peak_MB = memory.peak_MB();
  }
  state.SetItemsProcessed(state.iterations() * kSide * kSide);
  state.counters["peak_MB"] = peak_MB;
}

using Vertex = std::uint32_t;

// Unless a graph says otherwise, its vertices are the numbers of our states.
StateId stateOf(Vertex vertex) { return static_cast<StateId>(vertex); }
template <typename Graph>
Vertex vertexOf(StateId state, const Graph&) {
  return static_cast<Vertex>(state);
}
template <typename Graph>
boost::typed_identity_property_map<Vertex> indicesOf(const Graph&) {
  return {};
}

/// Our successor function as an incidence graph of Boost.Graph.
struct OurGraph {
  struct Edge {
    Vertex from;
    Vertex to;
    PathCost cost;
    bool operator==(const Edge&) const = default;
  };
  struct traversal_category : boost::vertex_list_graph_tag, boost::incidence_graph_tag {};
  using vertex_descriptor = Vertex;
  using edge_descriptor = Edge;
  using directed_category = boost::directed_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  using vertex_iterator = boost::counting_iterator<Vertex>;
  using vertices_size_type = std::size_t;
  struct EdgeOf {
    Vertex from = 0;
    Edge operator()(const Successor& step) const {
      return {from, static_cast<Vertex>(step.state), step.cost};
    }
  };
  using out_edge_iterator =
      boost::transform_iterator<EdgeOf, std::vector<Successor>::const_iterator, Edge, Edge>;
  using degree_size_type = std::size_t;

  const LargeBench* bench;
  mutable std::vector<Successor>
      next;  ///< of the vertex last asked for, which is all that A* holds
};

std::pair<OurGraph::vertex_iterator, OurGraph::vertex_iterator> vertices(const OurGraph& graph) {
  return {OurGraph::vertex_iterator(0),
          OurGraph::vertex_iterator(static_cast<Vertex>(graph.bench->graph.numStates()))};
}

std::size_t num_vertices(const OurGraph& graph) { return graph.bench->graph.numStates(); }

std::pair<OurGraph::out_edge_iterator, OurGraph::out_edge_iterator> out_edges(
    Vertex from, const OurGraph& graph) {
  graph.bench->steps(static_cast<StateId>(from), graph.next);
  const OurGraph::EdgeOf edge{from};
  return {{graph.next.begin(), edge}, {graph.next.end(), edge}};
}

std::size_t out_degree(Vertex from, const OurGraph& graph) {
  const auto [first, last] = out_edges(from, graph);
  return static_cast<std::size_t>(last - first);
}

Vertex source(const OurGraph::Edge& edge, const OurGraph&) { return edge.from; }
Vertex target(const OurGraph::Edge& edge, const OurGraph&) { return edge.to; }

auto weightsOf(const OurGraph&) {
  return boost::make_function_property_map<OurGraph::Edge>(
      [](const OurGraph::Edge& edge) { return edge.cost; });
}

struct EdgeCost {
  PathCost cost;
};
using ItsGraph = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, EdgeCost,
                                                    boost::no_property, Vertex, Vertex>;

auto weightsOf(const ItsGraph& graph) { return boost::get(&EdgeCost::cost, graph); }

ItsGraph itsGraph() {
  const LargeBench& bench = largeBench();
  std::vector<std::pair<Vertex, Vertex>> ends;
  std::vector<EdgeCost> costs;
  std::vector<Successor> next;
  for (Vertex from = 0; from < bench.graph.numStates(); ++from) {
    if (!bench.graph.valid(static_cast<StateId>(from))) continue;
    bench.steps(static_cast<StateId>(from), next);
    for (const Successor& step : next) {
      ends.emplace_back(from, static_cast<Vertex>(step.state));
      costs.push_back({step.cost});
    }
  }
  return {boost::edges_are_sorted, ends.begin(), ends.end(), costs.begin(),
          static_cast<Vertex>(bench.graph.numStates())};
}

using Grid = boost::grid_graph<2>;
using Cell2 = boost::graph_traits<Grid>::vertex_descriptor;  // column and row

/// States are numbered as the cells of the grid: the graph's other concepts have one symbol each.
StateId stateOf(const Cell2& cell) { return static_cast<StateId>(cell[0] + kSide * cell[1]); }

struct IsFree {
  const SymbolGraph* graph = nullptr;
  bool operator()(const Cell2& cell) const { return graph->valid(stateOf(cell)); }
};
using ItsGrid = boost::filtered_graph<Grid, boost::keep_all, IsFree>;

/// All steps cost the same.
auto weightsOf(const ItsGrid&) {
  return boost::static_property_map<PathCost>(rankOf(toPathCost(-std::log1p(-kStepDiscount)), 1));
}
auto indicesOf(const ItsGrid& graph) { return get(boost::vertex_index, graph.m_g); }
Cell2 vertexOf(StateId state, const ItsGrid&) {
  return {{index(state) % kSide, index(state) / kSide}};
}

template <typename Descriptor>
struct Heuristic {
  using argument_type = Descriptor;
  using result_type = PathCost;
  PathCost operator()(const Descriptor& vertex) const { return (*ours)(stateOf(vertex)); }
  const ProjectionHeuristic* ours;
};

struct GoalFound {};

/// Counts expansions; leaves the search at the goal, as Boost.Graph's examples do.
template <typename Descriptor>
class ToGoal : public boost::default_astar_visitor {
 public:
  ToGoal(const Descriptor& goal, std::size_t& expanded) : goal_(goal), expanded_(&expanded) {}

  template <typename Graph>
  void examine_vertex(const Descriptor& vertex, const Graph&) {
    ++*expanded_;
    if (vertex == goal_) throw GoalFound();
  }

 private:
  Descriptor goal_;
  std::size_t* expanded_;
};

template <typename Graph>
PathCost boostSearch(const Graph& graph, std::size_t& expanded) {
  const LargeBench& bench = largeBench();
  const std::size_t states = bench.graph.numStates();
  const auto start = vertexOf(bench.start, graph);
  const auto goal = vertexOf(bench.goal, graph);
  using Descriptor = std::remove_const_t<decltype(goal)>;
  const auto index_map = indicesOf(graph);
  std::vector<Descriptor> predecessors(states);
  std::vector<PathCost> distances(states);
  try {
    boost::astar_search(
        graph, start, Heuristic<Descriptor>{&bench.heuristic},
        boost::visitor(ToGoal<Descriptor>(goal, expanded))
            .vertex_index_map(index_map)
            .color_map(boost::make_two_bit_color_map(states, index_map))
            .weight_map(weightsOf(graph))
            .predecessor_map(boost::make_iterator_property_map(predecessors.begin(), index_map))
            .distance_map(boost::make_iterator_property_map(distances.begin(), index_map)));
  } catch (const GoalFound&) {
    std::vector<Descriptor> path{goal};
    while (path.back() != start) path.push_back(predecessors[get(index_map, path.back())]);
    benchmark::DoNotOptimize(path);
    return costOf(distances[get(index_map, goal)]);
  }
  return kOutOfReach;
}

template <typename Graph>
void boostAstar(benchmark::State& state, const Graph& graph, double graph_MB) {
  std::size_t expanded = 0;
  double peak_MB = 0;
  PathCost cost = 0;
  for (auto _ : state) {
    const testing::CountedMemory memory;
    cost = boostSearch(graph, expanded);
    if (cost == kOutOfReach) {
      state.SkipWithError("no path");
      break;
    }
    peak_MB = memory.peak_MB();
  }
  report(state, expanded, peak_MB, graph_MB, cost);
}

void boostOverOurGraph(benchmark::State& state) {
  boostAstar(state, OurGraph{&largeBench(), {}}, largeBench().graph_MB);
}

void boostOverItsGrid(benchmark::State& state) {
  const SymbolGraph& graph = largeBench().graph;
  const Grid grid(Cell2{{kSide, kSide}});
  // Of our graph it needs what is valid: a byte a state.
  boostAstar(state, ItsGrid(grid, {}, {&graph}), static_cast<double>(graph.numStates()) / 1e6);
}

void boostOverItsGraph(benchmark::State& state) {
  largeBench();  // is not counted
  const testing::CountedMemory memory;
  const ItsGraph graph = itsGraph();
  boostAstar(state, graph, memory.held_MB());
}

BENCHMARK(compileLargeBench)->Unit(benchmark::kMillisecond);
BENCHMARK(ourAstar)->Unit(benchmark::kMillisecond);
BENCHMARK(ourPlanner)->Unit(benchmark::kMillisecond);
BENCHMARK(boostOverItsGrid)->Unit(benchmark::kMillisecond);
BENCHMARK(boostOverOurGraph)->Unit(benchmark::kMillisecond);
BENCHMARK(boostOverItsGraph)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace conceptplan
