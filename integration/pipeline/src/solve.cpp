#include "conceptplan/pipeline/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/rendering/renderer.hpp"
#include "conceptplan/domain/scenario/reference.hpp"
#include "conceptplan/domain/simulation/simulator.hpp"
#include "conceptplan/fcl/fcl_validity.hpp"

namespace conceptplan {
namespace {

/// Milliseconds since it was made or last read.
class Stopwatch {
 public:
  double lap() {
    const auto now = Clock::now();
    const double milliseconds = std::chrono::duration<double, std::milli>(now - since_).count();
    since_ = now;
    return milliseconds;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point since_ = Clock::now();
};

/// Half the sum of absolute differences, over all concepts; 0 for equal beliefs.
double difference(const SymbolBelief& a, const SymbolBelief& b) {
  double total = 0;
  for (std::size_t k = 0; k < kNumConcepts; ++k)
    for (std::size_t s = 0; s < a[k].size(); ++s) total += 0.5 * std::abs(a[k][s] - b[k][s]);
  return total;
}

/// The position in `initial` of the object that changes most.
std::size_t mostChanged(const Percept& initial, const Percept& goal) {
  std::size_t best = initial.instances.size();
  double most = -1;
  for (std::size_t i = 0; i < initial.instances.size(); ++i) {
    const std::size_t j = goal.position(initial.instances[i]);
    if (j == goal.instances.size()) continue;
    const double change = difference(initial.beliefs[i], goal.beliefs[j]);
    if (change > most) most = change, best = i;
  }
  if (best == initial.instances.size())
    throw std::invalid_argument("no object is seen in both pictures");
  return best;
}

/// The motion in steps of 5 mm.
ReportMotion motionOf(const RefinementResult& refinement) {
  ReportMotion motion;
  for (const MotionPoint& point : refinement.trajectory.denseSamples(0.005)) {
    motion.points.emplace_back(point.x_m, point.y_m, point.lift_m);
  }
  motion.length_m = refinement.length_m;
  motion.clearance_m = refinement.clearance_m;
  motion.fallback = refinement.reason;
  return motion;
}

/// What the simulator shows after each step, as far as the plan is legal.
std::vector<RgbdImage> simulatedFrames(const Reference& reference, const Plan& plan) {
  Renderer renderer;
  World world = reference.task.initial;
  std::vector<RgbdImage> frames;
  for (const Action action : plan.actions) {
    if (advance(world, action)) break;
    frames.push_back(renderer.render(world, {reference.task.appearance, reference.domain}));
  }
  return frames;
}

/// Tells of symbols that are guesses.
void addDoubts(const std::string& picture, const Percept& percept, const SymbolGrounding& grounding,
               std::vector<std::string>& doubts) {
  for (std::size_t i = 0; i < percept.instances.size(); ++i) {
    const Symbols symbols = mostProbable(percept.beliefs[i]);
    for (const Concept which : kConcepts)
      if (!percept.fits[i][index(which)])
        doubts.push_back("In the " + picture + " picture, the " + std::string(name(which)) +
                         " of object " + std::to_string(percept.instances[i]) +
                         " is like none that was learned; it is read as " +
                         grounding.name(which, symbols[index(which)]) + ".");
  }
}

}  // namespace

SymbolicProblem problemOf(const Percept& initial, const Percept& goal,
                          std::optional<std::uint8_t> target) {
  const std::size_t at = target ? initial.position(*target) : mostChanged(initial, goal);
  if (at == initial.instances.size())
    throw std::invalid_argument("the target, instance " + std::to_string(*target) +
                                ", is not seen in the initial picture");
  const std::size_t in_goal = goal.position(initial.instances[at]);
  if (in_goal == goal.instances.size())
    throw std::invalid_argument("the target, instance " + std::to_string(initial.instances[at]) +
                                ", is not seen in the goal picture");
  return {{Workbench{}, initial.beliefs, at}, goal.beliefs[in_goal]};
}

Evaluation evaluationOf(const Task& task, const std::vector<Plan>& plans) {
  Evaluation evaluation;
  evaluation.best = judge(
      task, plans.empty() ? std::optional<ActionSequence>() : std::optional(plans.front().actions));
  for (std::size_t i = 0; i < std::min(kTopPlans, plans.size()); ++i)
    evaluation.top5 = evaluation.top5 || judge(task, plans[i].actions).succeeded();
  return evaluation;
}

Solution solveScenario(const Scenario& scenario, const Model& model, const Planner& planner,
                       const SolveOptions& options) {
  Solution solution;
  Stopwatch total, stage;
  const auto* pictures = std::get_if<PictureInput>(&scenario.input);
  Percept initial;
  if (pictures != nullptr) {
    initial = model.perceive(pictures->initial);
    const Percept goal = model.perceive(pictures->goal);
    addDoubts("initial", initial, model.symbolic().grounding, solution.doubts);
    addDoubts("goal", goal, model.symbolic().grounding, solution.doubts);
    try {
      solution.problem = problemOf(initial, goal, scenario.target);
    } catch (const std::invalid_argument& error) {
      throw InputError({scenario.fault("target", error.what())});
    }
    solution.instances = initial.instances;
  } else {
    solution.problem = problemOf(scenario, model.symbolic().cardinality());
    for (std::size_t i = 0; i < solution.problem.initial.objects.size(); ++i)
      solution.instances.push_back(static_cast<std::uint8_t>(i + 1));
  }
  solution.times.perceive_ms = stage.lap();

  const FclValidity validity;
  const SymbolGraph graph = compile(model.symbolic(), solution.problem, validity);
  solution.times.compile_ms = stage.lap();

  PlanQuery query;
  query.top = static_cast<std::size_t>(scenario.planner.top);
  query.limits = options.limits;
  query.seed = options.seed;
  solution.result = planner.solve(graph, query);
  solution.times.search_ms = stage.lap();

  if (scenario.refine_clearance_m && !solution.result.plans.empty()) {
    RefinementOptions refinement;
    refinement.clearance_m = *scenario.refine_clearance_m;
    solution.refinement = Refiner(refinement)
                              .refine(motionTaskOf(solution.problem, model.symbolic().grounding,
                                                   solution.result.plans.front()));
  }
  solution.times.refine_ms = stage.lap();

  if (pictures != nullptr && options.render && scenario.render && !solution.result.plans.empty())
    solution.frames = model.render(pictures->initial, initial,
                                   solution.instances[solution.problem.initial.target],
                                   solution.result.plans.front());
  solution.times.render_ms = stage.lap();

  if (scenario.reference) {
    const Reference reference = readReference(*scenario.reference);
    if (hasSolution(reference))
      solution.evaluation = evaluationOf(reference.task, solution.result.plans);
  }
  solution.times.total_ms = total.lap();
  return solution;
}

Report reportOf(const Scenario& scenario, const Model& model, const Solution& solution,
                const std::string& planner, std::uint64_t seed) {
  Report report;
  report.title = scenario.name;
  if (const auto* pictures = std::get_if<PictureInput>(&scenario.input)) {
    report.initial = pictures->initial;
    report.goal = pictures->goal;
  }
  report.problem = solution.problem;
  report.instances = solution.instances;
  report.grounding = model.symbolic().grounding;
  report.doubts = solution.doubts;
  report.result = solution.result;
  if (solution.refinement) report.motion = motionOf(*solution.refinement);
  for (const RgbdImage& frame : solution.frames) report.frames.push_back({frame, {}});
  if (scenario.reference) {
    const Reference reference = readReference(*scenario.reference);
    if (!solution.result.plans.empty()) {
      const auto simulated = simulatedFrames(reference, solution.result.plans.front());
      report.frames.resize(solution.result.plans.front().actions.size());
      for (std::size_t i = 0; i < simulated.size(); ++i) report.frames[i].reference = simulated[i];
    }
    if (solution.evaluation) {
      const Judgement& best = solution.evaluation->best;
      report.verdict =
          best.succeeded()
              ? "In the simulator the best plan reaches the goal."
              : "In the simulator the best plan fails: " + std::string(name(*best.failure)) + ".";
    }
  }
  const StageTimes& times = solution.times;
  report.times_ms = {{"perceive", times.perceive_ms}, {"compile", times.compile_ms},
                     {"search", times.search_ms},     {"refine", times.refine_ms},
                     {"render", times.render_ms},     {"total", times.total_ms}};
  report.facts = {
      {"planner", planner}, {"seed", std::to_string(seed)}, {"model", model.manifest().name}};
  report.versions = {{"ConceptPlan", CONCEPTPLAN_VERSION}, {"model", model.manifest().revision}};
  return report;
}

}  // namespace conceptplan
