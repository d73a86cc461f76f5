#include "plan_check.hpp"

#include "conceptplan/planners/pddl/plan_replay.hpp"
#include "exit_code.hpp"
#include "scenario_check.hpp"
#include "scenario_solver.hpp"

namespace conceptplan::cli {
namespace {

/// What the file should say of its cost.
std::int64_t costOf(const PlanFile& plan, const PlanReplay& replayed) {
  return plan.unit_cost ? static_cast<std::int64_t>(replayed.states.size()) : replayed.cost;
}

Json toJson(const PlanFile& plan, const PlanReplay& replayed) {
  Json document{{"ok", !replayed.failure},
                {"steps", plan.steps.size()},
                {"replayed", replayed.states.size()},
                {"cost", replayed.cost},
                {"probability", replayed.probability},
                {"stated_cost", plan.cost ? Json(*plan.cost) : Json()},
                {"failure", nullptr}};
  if (replayed.failure) {
    const std::size_t step = replayed.failure->step;
    const bool at_step = step < plan.steps.size();
    document["failure"] = {{"step", at_step ? Json(step + 1) : Json()},
                           {"line", at_step ? Json(plan.steps[step].line) : Json()},
                           {"reason", replayed.failure->reason}};
  }
  return document;
}

}  // namespace

int checkPlan(const std::filesystem::path& plan_file, const std::string& scenario,
              const std::string& model, const DeterminisationOptions& options, Session& session) {
  const PlanFile plan = readPlanFile(plan_file);
  ScenarioSolver solver;
  const CompiledScenario compiled = solver.compile(findScenario(scenario), model);
  PlanReplay replayed =
      replay(compiled.graph, plan.steps, determinisationOf(compiled.scenario, options));
  if (replayed.failure && replayed.failure->object) {
    replayed.failure->reason =
        explanation(*replayed.failure, objectNames(compiled.scenario, *compiled.model));
  }
  Console& console = session.console;
  console.printJson(toJson(plan, replayed));
  const std::string sums = std::to_string(replayed.states.size()) + " actions, cost " +
                           std::to_string(replayed.cost) + ", probability " +
                           decimal(replayed.probability, 4);
  if (!replayed.failure) {
    console.print(plan_file.string() + ": reaches the goal; " + sums);
    if (plan.cost && *plan.cost != costOf(plan, replayed)) {
      console.message(plan_file.string() + ": states the cost " + std::to_string(*plan.cost));
    }
    return kDone;
  }
  const std::size_t step = replayed.failure->step;
  if (step < plan.steps.size()) {
    console.error("conceptplan: " + plan_file.string() + ":" +
                  std::to_string(plan.steps[step].line) + ": step " + std::to_string(step + 1) +
                  ", " + std::string(name(plan.steps[step].action)) + ": " +
                  replayed.failure->reason);
  } else {
    console.error("conceptplan: " + plan_file.string() + ": " + replayed.failure->reason);
  }
  console.print("before that: " + sums);
  return kNoPlan;
}

}  // namespace conceptplan::cli
