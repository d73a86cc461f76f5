#include "conceptplan/pipeline/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "conceptplan/domain/dataset/task_dataset.hpp"
#include "conceptplan/domain/input_error.hpp"
#include "conceptplan/domain/rendering/renderer.hpp"
#include "conceptplan/domain/scenario/reference.hpp"
#include "conceptplan/domain/simulation/simulator.hpp"
#include "conceptplan/fcl/fcl_validity.hpp"
#include "conceptplan/pipeline/object_name.hpp"
#include "conceptplan/planners/graph_source.hpp"
#include "conceptplan/planners/search_guard.hpp"

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

/// The objects of the simulated world that the steps of a plan move, which have the order of their
/// ids; none if there is one target.
std::vector<std::size_t> movedInWorld(const Plan& plan, std::span<const std::uint8_t> instances) {
  std::vector<std::size_t> moved;
  for (const std::size_t object : plan.moved) moved.push_back(instances[object] - 1u);
  return moved;
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
std::vector<RgbdImage> simulatedFrames(const Reference& reference, const Solution& solution,
                                       const Plan& plan) {
  const std::vector<std::size_t> moved = movedInWorld(plan, solution.instances);
  Renderer renderer;
  World world = reference.task.initial;
  std::vector<RgbdImage> frames;
  for (std::size_t i = 0; i < plan.actions.size(); ++i) {
    world.target = movedObject(world, moved, i);
    if (advance(world, plan.actions[i])) break;
    frames.push_back(renderer.render(world, {reference.task.appearance, reference.domain}));
  }
  return frames;
}

/// What an object of either picture is called. The solution has the names of those of the first.
std::string nameOf(const Percept& percept, std::size_t object, const SymbolGrounding& grounding,
                   const Solution& solution) {
  const std::uint8_t instance = percept.instances[object];
  const auto known = std::ranges::find(solution.instances, instance);
  return known == solution.instances.end()
             ? objectName(grounding, percept.beliefs[object], instance)
             : solution.names[static_cast<std::size_t>(known - solution.instances.begin())];
}

/// Tells of symbols that are guesses. The solution has the names of the objects already.
void addDoubts(const std::string& picture, const Percept& percept,
               const std::vector<bool>& recognised, const SymbolGrounding& grounding,
               Solution& solution) {
  for (std::size_t i = 0; i < percept.instances.size(); ++i) {
    const std::string object = nameOf(percept, i, grounding, solution);
    const Symbols symbols = mostProbable(percept.beliefs[i]);
    for (const Concept which : kConcepts)
      if (!percept.fits[i][index(which)])
        solution.doubts.push_back("In the " + picture + " picture, the " +
                                  std::string(name(which)) + " of " + object +
                                  " is like none that was learned; it is read as " +
                                  grounding.name(which, symbols[index(which)]) + ".");
    if (!recognised[i])
      solution.doubts.push_back(
          "In the " + picture + " picture, " + object +
          " does not look like what it is read as; its symbols may be guesses.");
  }
}

/// Takes over the ids of the objects, and names them.
void takeObjects(std::vector<std::uint8_t> instances, std::span<const SymbolBelief> beliefs,
                 const SymbolGrounding& grounding, Solution& solution) {
  solution.instances = std::move(instances);
  for (std::size_t i = 0; i < beliefs.size(); ++i)
    solution.names.push_back(objectName(grounding, beliefs[i], solution.instances[i]));
}

/// Position of a target in what was read of a picture.
std::size_t seenAt(const Percept& percept, std::uint8_t target, const std::string& picture) {
  const std::size_t at = percept.position(target);
  if (at == percept.instances.size())
    throw std::invalid_argument("the target, instance " + std::to_string(target) +
                                ", is not seen in the " + picture + " picture");
  return at;
}

/// Makes the solution's problem that of the first of several targets. The solution has the names of
/// the objects already.
void takeTargets(JointProblem problem, Solution& solution) {
  for (TargetGoal& target : problem.targets) target.name = solution.names[target.object];
  const TargetGoal& first = problem.targets.front();
  solution.problem = {{problem.workbench, std::move(problem.objects), first.object}, first.goal};
  solution.targets = std::move(problem.targets);
}

/// Reads what two pictures show into the solution. @returns what was read of the first one
Percept readPictures(const Scenario& scenario, const PictureInput& pictures, const Model& model,
                     Solution& solution) {
  TaskReading read = model.readTask(pictures.initial, pictures.goal);
  const Percept &initial = read.initial, &goal = read.goal;
  const SymbolGrounding& grounding = model.symbolic().grounding;
  takeObjects(initial.instances, initial.beliefs, grounding, solution);
  addDoubts("initial", initial, read.initial_recognised, grounding, solution);
  addDoubts("goal", goal, read.goal_recognised, grounding, solution);
  for (std::size_t i = 0; i < goal.instances.size(); ++i)
    if (read.turned_round[i])
      solution.doubts.push_back("How " + nameOf(goal, i, grounding, solution) +
                                " was turned between the pictures was measured by comparing them; "
                                "in one of the two it looks turned the other way round.");
  const bool several = !scenario.targets.empty();
  try {
    if (several) {
      takeTargets(jointProblemOf(initial, goal, scenario.targets), solution);
    } else {
      solution.problem = problemOf(initial, goal, scenario.target);
    }
  } catch (const std::invalid_argument& error) {
    throw InputError({scenario.fault(several ? "targets" : "target", error.what())});
  }
  return std::move(read.initial);
}

void readSymbols(const Scenario& scenario, const Model& model, Solution& solution) {
  const SymbolicModel& symbolic = model.symbolic();
  const auto name_objects = [&](std::span<const SymbolBelief> objects) {
    std::vector<std::uint8_t> instances(objects.size());
    std::iota(instances.begin(), instances.end(), std::uint8_t{1});
    takeObjects(std::move(instances), objects, symbolic.grounding, solution);
  };
  if (scenario.targets.empty()) {
    solution.problem = problemOf(scenario, symbolic.cardinality());
    name_objects(solution.problem.initial.objects);
  } else {
    JointProblem problem = jointProblemOf(scenario, symbolic.cardinality());
    name_objects(problem.objects);
    takeTargets(std::move(problem), solution);
  }
}

/// Reads pictures or given symbols into the solution. @returns what was read of the first picture
Percept readInput(const Scenario& scenario, const Model& model, Solution& solution) {
  const auto* pictures = std::get_if<PictureInput>(&scenario.input);
  if (pictures != nullptr) return readPictures(scenario, *pictures, model, solution);
  readSymbols(scenario, model, solution);
  return {};
}

/// What refines the best plan; nothing if the scenario asks for no motion, or has several targets.
/// @throws InputError if there is no such algorithm, or an option is out of range.
std::optional<Refiner> refinerOf(const Scenario& scenario, const SearchLimits& limits) {
  if (!scenario.refine || !scenario.targets.empty()) return std::nullopt;
  RefinementOptions options;
  options.clearance_m = scenario.refine->clearance_m;
  options.algorithm = scenario.refine->algorithm.value_or(options.algorithm);
  options.max_evaluations = scenario.refine->max_evaluations.value_or(options.max_evaluations);
  options.timeout_s = limits.timeout_s;
  options.cancel = limits.cancel;
  try {
    return Refiner(options);
  } catch (const std::invalid_argument& error) {
    throw InputError({scenario.fault("refine", error.what())});
  }
}

/// Fills the result of a solution whose problem has been read.
using SearchStage = std::function<void(Solution&, const PlanQuery&, Stopwatch& stage)>;

Solution solveWith(const SearchStage& search, const Scenario& scenario, const Model& model,
                   const SolveOptions& options) {
  Solution solution;
  Stopwatch total, stage;
  const std::optional<Refiner> refiner = refinerOf(scenario, options.limits);
  const auto* pictures = std::get_if<PictureInput>(&scenario.input);
  const Percept initial = readInput(scenario, model, solution);
  solution.times.perceive_ms = stage.lap();

  PlanQuery query;
  query.top = static_cast<std::size_t>(scenario.planner.top);
  query.limits = options.limits;
  query.seed = options.seed;
  query.count_rejections = true;
  search(solution, query, stage);
  solution.result.reason = explanation(solution.result, solution.names);
  solution.times.search_ms = stage.lap();

  const bool several = !solution.targets.empty();
  if (refiner && !solution.result.plans.empty()) {
    solution.refinement = refiner->refine(
        motionTaskOf(solution.problem, model.symbolic().grounding, solution.result.plans.front()));
  }
  solution.times.refine_ms = stage.lap();

  if (pictures != nullptr && options.render && scenario.render && !solution.result.plans.empty()) {
    try {
      solution.frames = model.render(pictures->initial, initial,
                                     solution.instances[solution.problem.initial.target],
                                     solution.result.plans.front());
    } catch (const std::invalid_argument& error) {
      if (!several) throw;
      solution.doubts.push_back("No frames were predicted: " + std::string(error.what()) + ".");
    }
  }
  solution.times.render_ms = stage.lap();

  if (scenario.reference) {
    const Reference reference = readReference(*scenario.reference);
    if (hasSolution(reference))
      solution.evaluation = evaluationOf(reference.task, solution.result.plans, solution.instances);
  }
  solution.times.total_ms = total.lap();
  return solution;
}

}  // namespace

Evaluation evaluationOf(const Task& task, const std::vector<Plan>& plans,
                        std::span<const std::uint8_t> instances) {
  Evaluation evaluation;
  if (plans.empty()) evaluation.best = judge(task, std::nullopt);
  for (std::size_t i = 0; i < std::min(kTopPlans, plans.size()); ++i) {
    const Judgement judgement = judge(task, plans[i].actions, movedInWorld(plans[i], instances));
    if (i == 0) evaluation.best = judgement;
    evaluation.top5 = evaluation.top5 || judgement.succeeded();
  }
  return evaluation;
}

SymbolicProblem problemOf(const Percept& initial, const Percept& goal,
                          std::optional<std::uint8_t> target) {
  const std::size_t at = target ? seenAt(initial, *target, "initial") : mostChanged(initial, goal);
  const std::size_t in_goal = seenAt(goal, initial.instances[at], "goal");
  return {{Workbench{}, initial.beliefs, at}, goal.beliefs[in_goal]};
}

JointProblem jointProblemOf(const Percept& initial, const Percept& goal,
                            std::span<const std::uint8_t> targets) {
  JointProblem problem{Workbench{}, initial.beliefs, {}};
  for (const std::uint8_t target : targets)
    problem.targets.push_back({seenAt(initial, target, "initial"),
                               goal.beliefs[seenAt(goal, target, "goal")],
                               "object " + std::to_string(target)});
  return problem;
}

std::vector<std::string> objectNames(const Scenario& scenario, const Model& model) {
  Solution solution;
  readInput(scenario, model, solution);
  return std::move(solution.names);
}

SymbolGraph compileScenario(const Scenario& scenario, const Model& model) {
  if (!scenario.targets.empty())
    throw InputError({scenario.fault("targets", "several targets have no graph of their states")});
  Solution solution;
  readInput(scenario, model, solution);
  return compile(model.symbolic(), solution.problem, FclValidity());
}

Solution solveScenario(const Scenario& scenario, const Model& model, const Planner& planner,
                       const SolveOptions& options) {
  if (!scenario.targets.empty())
    throw InputError({scenario.fault("targets", "several targets need a planner for several")});
  const SearchStage search = [&](Solution& solution, PlanQuery query, Stopwatch& stage) {
    const FclValidity validity;
    const GraphSource source{model.symbolic(), validity};
    query.source = &source;
    SearchGuard guard(query.limits);
    const std::optional<SymbolGraph> graph =
        compile(model.symbolic(), solution.problem, validity, guard);
    solution.times.compile_ms = stage.lap();
    if (graph) {
      solution.result = planner.solve(*graph, query);
    } else {
      solution.result.status = *guard.stopped();
      solution.result.reason = guard.reason() + " while the scenario was compiled";
    }
  };
  return solveWith(search, scenario, model, options);
}

Solution solveScenario(const Scenario& scenario, const Model& model, const JointPlanner& planner,
                       const SolveOptions& options) {
  if (scenario.targets.empty())
    throw std::invalid_argument(scenario.name + ": no `targets`, where several are expected");
  const SearchStage search = [&](Solution& solution, const PlanQuery& query, Stopwatch&) {
    const SymbolicScene& scene = solution.problem.initial;
    try {
      solution.result =
          planner.solve(model.symbolic(), {scene.workbench, scene.objects, solution.targets},
                        FclValidity{}, query);
    } catch (const std::invalid_argument& error) {
      throw InputError({scenario.fault("targets", error.what())});
    }
  };
  return solveWith(search, scenario, model, options);
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
  report.targets = solution.targets;
  report.instances = solution.instances;
  report.grounding = model.symbolic().grounding;
  report.doubts = solution.doubts;
  report.result = solution.result;
  report.legality_threshold = solution.legality_threshold;
  if (solution.refinement) report.motion = motionOf(*solution.refinement);
  for (const RgbdImage& frame : solution.frames) report.frames.push_back({frame, {}});
  if (scenario.reference) {
    const Reference reference = readReference(*scenario.reference);
    if (!solution.result.plans.empty()) {
      const auto simulated = simulatedFrames(reference, solution, solution.result.plans.front());
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
