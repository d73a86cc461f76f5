#include "conceptplan/nlopt/refiner.hpp"

#include <nlopt.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <utility>

#include "motion_program.hpp"

namespace conceptplan {
namespace {

constexpr double kLengthTolerance_m = 1e-6;  // rounding of the sum of chords
constexpr double kReach_m = 0.04;            // pairs this near to what is allowed are watched
/// The solvers' first step is about as long as the gradient; this makes it centimetres, so that it
/// does not lead through obstacles.
constexpr double kObjectiveScale = 0.02;
/// A solution that misses more of the clearance, at nothing that it overlooked, is none; what it
/// misses less lies between two samples.
constexpr double kMostMissing_m = 0.002;
constexpr int kMostRounds = 4;  // of adding what a solution overlooked

struct NamedAlgorithm {
  RefinementAlgorithm entry;
  nlopt_algorithm id;
};

constexpr std::array<NamedAlgorithm, 4> kAlgorithms{{
    {{"slsqp", "sequential quadratic programming with gradients; the fastest here",
      "D. Kraft, A software package for sequential quadratic programming, DFVLR-FB 88-28, 1988"},
     NLOPT_LD_SLSQP},
    {{"mma", "method of moving asymptotes with gradients",
      "K. Svanberg, A class of globally convergent optimization methods based on conservative "
      "convex separable approximations, SIAM J. Optim. 12 (2002)"},
     NLOPT_LD_MMA},
    {{"ccsaq", "conservative convex separable approximations, quadratic, with gradients",
      "K. Svanberg, SIAM J. Optim. 12 (2002)"},
     NLOPT_LD_CCSAQ},
    {{"cobyla", "linear approximations without gradients; slow",
      "M. J. D. Powell, A direct search optimization method that models the objective and "
      "constraint functions by linear interpolation, 1994"},
     NLOPT_LN_COBYLA},
}};

const NamedAlgorithm* find(std::string_view name) {
  const auto found =
      std::find_if(kAlgorithms.begin(), kAlgorithms.end(),
                   [name](const NamedAlgorithm& named) { return named.entry.name == name; });
  return found == kAlgorithms.end() ? nullptr : &*found;
}

void require(bool holds, const std::string& what, double value, const std::string& expected) {
  if (!holds) {
    throw std::invalid_argument(what + " is " + std::to_string(value) + ", expected " + expected);
  }
}

std::string millimetres(double length_m) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f mm", 1000 * length_m);
  return text;
}

/// Tells when a refinement must end.
class Deadline {
 public:
  explicit Deadline(const RefinementOptions& options)
      : options_(options), since_(std::chrono::steady_clock::now()) {}

  /// Why it must end; empty if it need not.
  std::string reason() const {
    if (options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed)) {
      return "cancelled";
    }
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - since_;
    if (passed.count() < options_.timeout_s) return {};
    return "stopped at the time limit of " + std::to_string(options_.timeout_s) + " s";
  }

 private:
  const RefinementOptions& options_;
  std::chrono::steady_clock::time_point since_;
};

/// One run of NLopt.
struct Minimisation {
  const MotionProgram& program;
  const Deadline& deadline;
  nlopt_opt solver;
};

double objectiveOf(unsigned count, const double* variables, double* gradient, void* data) {
  const auto& minimisation = *static_cast<const Minimisation*>(data);
  if (!minimisation.deadline.reason().empty()) nlopt_force_stop(minimisation.solver);
  const double value =
      minimisation.program.objective(Eigen::Map<const Eigen::VectorXd>(variables, count), gradient);
  if (gradient != nullptr) Eigen::Map<Eigen::VectorXd>(gradient, count) *= kObjectiveScale;
  return kObjectiveScale * value;
}

void constraintsOf(unsigned, double* values, unsigned count, const double* variables,
                   double* gradients, void* data) {
  static_cast<const Minimisation*>(data)->program.constraints(
      Eigen::Map<const Eigen::VectorXd>(variables, count), values, gradients);
}

/// Takes the variables to a local optimum, or as near to one as the limits allow.
/// @return evaluations.
int minimise(const MotionProgram& program, nlopt_algorithm algorithm, int max_evaluations,
             const Deadline& deadline, Eigen::VectorXd& variables) {
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> solver(
      nlopt_create(algorithm, static_cast<unsigned>(program.numVariables())), &nlopt_destroy);
  Minimisation minimisation{program, deadline, solver.get()};
  nlopt_set_min_objective(solver.get(), &objectiveOf, &minimisation);
  nlopt_set_lower_bounds(solver.get(), program.lowerBounds().data());
  nlopt_set_upper_bounds(solver.get(), program.upperBounds().data());
  if (program.numConstraints() > 0) {
    const std::vector<double> tolerances(program.numConstraints(), 1e-5);
    nlopt_add_inequality_mconstraint(solver.get(), static_cast<unsigned>(tolerances.size()),
                                     &constraintsOf, &minimisation, tolerances.data());
  }
  nlopt_set_ftol_rel(solver.get(), 1e-4);
  nlopt_set_maxeval(solver.get(), max_evaluations);
  nlopt_set_initial_step1(solver.get(), 0.02);
  double least = 0;
  // Whatever the solver says of its success, the motion is measured afterwards.
  nlopt_optimize(solver.get(), variables.data(), &least);
  return nlopt_get_numevals(solver.get());
}

/// Why no motion can keep the clearance, since the target has to stand where it comes too near to
/// something; empty if it need not.
std::string nearnessAtRest(const MotionTask& task, double wanted_m) {
  for (std::size_t i = 0; i < task.waypoints.size(); ++i) {
    const bool is_start = i == 0;
    const bool is_goal = i + 1 == task.waypoints.size();
    const UprightPrism target = task.target(i, task.waypoints[i].p_W);
    const std::string place = is_start  ? "the start"
                              : is_goal ? "the goal"
                                        : "step " + std::to_string(i);
    const double edge_m = edgeClearance_m(task.workbench, target);
    if (edge_m < wanted_m && (is_start || is_goal || task.waypoints[i].in_place)) {
      return place + " is " + millimetres(edge_m) + " from the workbench's edge, " +
             millimetres(wanted_m) + " are asked";
    }
    if (!is_start && !is_goal) continue;
    for (std::size_t k = 0; k < task.obstacles.size(); ++k) {
      const double distance_m = clearance_m(target, task.obstacles[k]);
      if (distance_m < wanted_m) {
        return place + " is " + millimetres(distance_m) + " from obstacle " +
               std::to_string(k + 1) + ", " + millimetres(wanted_m) + " are asked";
      }
    }
  }
  return {};
}

/// The moves on whose way the discrete plan comes too near to an obstacle, and all moves between
/// the same two places. [actions]
std::vector<bool> movesToLift(const MotionTask& task, double wanted_m) {
  std::vector<bool> lifted(task.waypoints.size() - 1, false);
  for (std::size_t first = 0; first < lifted.size();) {
    std::size_t last = first;  // of the moves between two places, one past the end
    bool near = false;
    for (; last < lifted.size() && !task.waypoints[last + 1].in_place; ++last) {
      const UprightPrism target = task.target(last + 1, task.waypoints[last].p_W);
      for (const UprightPrism& obstacle : task.obstacles) {
        near = near || clearanceAlong_m(target, task.waypoints[last + 1].p_W, obstacle) < wanted_m;
      }
    }
    std::fill(lifted.begin() + static_cast<std::ptrdiff_t>(first),
              lifted.begin() + static_cast<std::ptrdiff_t>(last), near);
    first = last + 1;
  }
  return lifted;
}

/// A motion with its measures.
struct Candidate {
  Trajectory trajectory;
  double length_m;
  double clearance_m;
};

Candidate measure(const MotionTask& task, Trajectory trajectory) {
  const double length = length_m(trajectory);
  const double clearance = clearance_m(task, trajectory);
  return {std::move(trajectory), length, clearance};
}

/// The best motion near the discrete one that the solver finds, whether it is clear or not.
Candidate solve(const MotionTask& task, const RefinementOptions& options, const Candidate& discrete,
                const std::vector<bool>& lifted, const Deadline& deadline, int& evaluations) {
  MotionProgram program(task, options, discrete.trajectory, lifted);
  Candidate best = discrete;
  if (program.numVariables() == 0) return best;
  for (int round = 0; round < kMostRounds && deadline.reason().empty(); ++round) {
    // From the plan each time: a motion that went through an obstacle cannot be led out of it.
    Eigen::VectorXd variables = program.startOf(discrete.trajectory);
    const double missing_m = options.clearance_m - best.clearance_m;
    const bool overlooked = (round == 0 ? program.select(best.trajectory, kReach_m)
                                        : program.selectOverlooked(best.trajectory)) > 0;
    if (round > 0 && !overlooked && missing_m > kMostMissing_m) break;
    if (round > 0 && !overlooked) program.keepFurther(missing_m);
    evaluations += minimise(program, find(options.algorithm)->id, options.max_evaluations, deadline,
                            variables);
    if (!variables.allFinite()) return discrete;
    best = measure(task, program.trajectoryOf(variables));
    if (best.clearance_m >= options.clearance_m) break;
  }
  return best;
}

/// Why the motion is no answer; empty if it is one.
std::string faultOf(const Candidate& motion, const Candidate& discrete, double wanted_m) {
  if (!(motion.clearance_m >= wanted_m)) {
    return "keeps " + millimetres(motion.clearance_m) + " of the " + millimetres(wanted_m) +
           " asked";
  }
  if (!(motion.length_m <= discrete.length_m + kLengthTolerance_m)) {
    return "is longer than the discrete plan, " + millimetres(motion.length_m) + " against " +
           millimetres(discrete.length_m);
  }
  return {};
}

}  // namespace

const std::vector<RefinementAlgorithm>& refinementAlgorithms() {
  static const std::vector<RefinementAlgorithm> algorithms = [] {
    std::vector<RefinementAlgorithm> entries;
    for (const NamedAlgorithm& named : kAlgorithms) entries.push_back(named.entry);
    return entries;
  }();
  return algorithms;
}

Refiner::Refiner(const RefinementOptions& options) : options_(options) {
  require(options.clearance_m >= 0 && options.clearance_m <= 1, "clearance_m", options.clearance_m,
          "a number in [0, 1]");
  require(options.action_s > 0 && std::isfinite(options.action_s), "action_s", options.action_s,
          "> 0");
  require(options.jerk_weight >= 0 && std::isfinite(options.jerk_weight), "jerk_weight",
          options.jerk_weight, ">= 0");
  require(options.cell_reach >= 0 && options.cell_reach < 0.5, "cell_reach", options.cell_reach,
          "a number in [0, 0.5)");
  require(options.max_lift_m >= 0 && std::isfinite(options.max_lift_m), "max_lift_m",
          options.max_lift_m, ">= 0");
  require(options.timeout_s > 0, "timeout_s", options.timeout_s, "> 0");
  require(options.max_evaluations >= 1, "max_evaluations", options.max_evaluations, ">= 1");
  if (find(options.algorithm) == nullptr) {
    throw std::invalid_argument("algorithm is " + options.algorithm +
                                ", expected slsqp, mma, ccsaq or cobyla");
  }
}

RefinementResult Refiner::refine(const MotionTask& task) const {
  if (task.waypoints.empty()) throw std::invalid_argument("a motion without a waypoint");
  bool measured = true;
  for (std::size_t i = 0; i < task.waypoints.size(); ++i) {
    measured = measured && task.target(i, task.waypoints[i].p_W).measured();
  }
  for (const UprightPrism& obstacle : task.obstacles) measured = measured && obstacle.measured();
  if (!measured) {
    throw std::invalid_argument("a body of the motion has no measure");
  }
  const Deadline deadline(options_);
  const Candidate discrete = measure(task, discreteTrajectory(task, options_.action_s));
  Candidate motion = discrete;
  int evaluations = 0;
  std::string reason = nearnessAtRest(task, options_.clearance_m);
  if (reason.empty()) {
    motion = solve(task, options_, discrete, {}, deadline, evaluations);
    const std::string pushed = faultOf(motion, discrete, options_.clearance_m);
    if (!pushed.empty()) reason = "pushed, the motion " + pushed;
    const auto lifted =
        pushed.empty() ? std::vector<bool>() : movesToLift(task, options_.clearance_m);
    if (std::find(lifted.begin(), lifted.end(), true) != lifted.end()) {
      motion = solve(task, options_, discrete, lifted, deadline, evaluations);
      const std::string fault = faultOf(motion, discrete, options_.clearance_m);
      reason = fault.empty() ? "" : reason + "; lifted, it " + fault;
    }
  }
  if (const std::string late = deadline.reason(); !late.empty()) reason = late;
  if (!reason.empty()) motion = discrete;
  return {motion.trajectory,
          motion.length_m,
          motion.clearance_m,
          !reason.empty(),
          reason,
          motion.trajectory.controlPoints().row(3).maxCoeff(),
          squaredJerk(motion.trajectory),
          discrete.length_m,
          discrete.clearance_m,
          evaluations};
}

}  // namespace conceptplan
