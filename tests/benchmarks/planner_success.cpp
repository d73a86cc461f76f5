// Solves level-4 tasks from true symbols with every planner, or those named, and prints how many it
// solves within a second of processor time, how fast and how well. Fails where a planner does less
// than it promises: planner_success [TASKS [PLANNER...]].
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <set>
#include <string>

#include "conceptplan/domain/simulation/judgement.hpp"
#include "conceptplan/ompl/ompl_planner.hpp"
#include "integration/ompl/task_graph.hpp"

using namespace conceptplan;

namespace {

/// Least share of the tasks, all of which have a solution, that a planner must solve.
double leastSolved(const std::string& planner) {
  // These sample, or leave out much of what they meet, and promise no plan.
  const bool complete = planner != "beam" && planner != "mcts";
  return planner.starts_with("ompl-") ? 0.99 : complete ? 1 : 0;
}

/// Whether all plans of a planner must be shortest ones.
bool isOptimal(const std::string& planner) {
  static const std::set<std::string> kOptimal{"belief", "bfs",   "dijkstra",
                                              "astar",  "kbest", "idastar"};
  return kOptimal.contains(planner);
}

}  // namespace

int main(int argc, char** argv) {
  const int tasks = argc > 1 ? std::atoi(argv[1]) : 1000;
  PlanQuery query;
  query.top = 1;
  query.limits.timeout_s = 600;  // others may keep the processor busy
  const std::set<std::string> wanted(argv + std::min(argc, 2), argv + argc);
  PlannerRegistry registry = PlannerRegistry::standard();
  addOmplPlanners(registry);
  bool kept = true;
  std::printf("%-16s %9s %9s %9s %9s %9s %9s\n", "planner", "solved %", "median ms", "99 % ms",
              "max ms", "steps", "ASE");
  for (const PlannerEntry& entry : registry.entries()) {
    if (!wanted.empty() && !wanted.contains(entry.name)) continue;
    const std::unique_ptr<Planner> planner = registry.make(entry.name);
    std::vector<double> times_ms;
    std::size_t expanded = 0;
    int solved = 0;
    double efficiency = 0;
    for (int i = 0; i < tasks; ++i) {
      const Task task = testing::testTask(4, i);
      const auto graph = testing::graphOf(task);
      query.seed = static_cast<std::uint64_t>(i);
      const std::clock_t begin = std::clock();
      const PlanResult result = planner->solve(*graph, query);
      times_ms.push_back(1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      expanded += result.statistics.expanded;
      if (result.plans.empty() || times_ms.back() > 1000) continue;
      const Judgement judgement = judge(task, result.plans.front().actions);
      if (!judgement.succeeded()) continue;
      ++solved;
      efficiency += *judgement.efficiency;
    }
    std::sort(times_ms.begin(), times_ms.end());
    const auto count = static_cast<double>(tasks);
    std::printf("%-16s %9.1f %9.2f %9.2f %9.2f %9.0f %9.3f\n", entry.name.c_str(),
                100 * solved / count, times_ms[times_ms.size() / 2],
                times_ms[times_ms.size() * 99 / 100], times_ms.back(),
                static_cast<double>(expanded) / count, efficiency / std::max(solved, 1));
    if (solved < leastSolved(entry.name) * count) {
      kept = false;
      std::printf("  too few: at least %.0f %% are promised\n", 100 * leastSolved(entry.name));
    }
    if (isOptimal(entry.name) && efficiency < solved) {
      kept = false;
      std::printf("  not all are shortest plans, which is promised\n");
    }
  }
  return kept ? EXIT_SUCCESS : EXIT_FAILURE;
}
