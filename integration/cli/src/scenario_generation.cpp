#include "scenario_generation.hpp"

#include <algorithm>
#include <memory>
#include <mutex>

#include "conceptplan/domain/rendering/renderer.hpp"
#include "conceptplan/domain/simulation/second_target.hpp"
#include "conceptplan/pipeline/parallel_work.hpp"

namespace conceptplan::cli {
namespace {

/// The symbol that bears the name of a value.
SymbolId symbolNamed(const SymbolGrounding& grounding, Concept which, std::size_t value) {
  static const SymbolGrounding kStandard = standardGrounding();
  const std::string expected = kStandard.name(which, SymbolId{static_cast<std::int32_t>(value)});
  const std::vector<std::string>& names = grounding.names[index(which)];
  const auto found = std::find(names.begin(), names.end(), expected);
  if (found == names.end()) {
    throw InputError({Fault{"--symbols-only",
                            {},
                            {},
                            std::string(name(which)),
                            "the model has no symbol named \"" + expected + "\""}});
  }
  return SymbolId{static_cast<std::int32_t>(found - names.begin())};
}

/// The task of that number with a second target; with that of another seed where there is no plan.
Task drawTwoTargetTask(TaskOptions options, int i) {
  const std::uint64_t seed = options.seed;
  for (std::uint64_t attempt = 0;; ++attempt) {
    if (attempt > 0) options.seed = stableHash({seed, attempt});
    RandomStream random{options.seed, static_cast<std::uint64_t>(options.level),
                        static_cast<std::uint64_t>(i)};
    if (auto task = withSecondTarget(TaskGenerator(options).task(i), random)) return *task;
  }
}

/// The target in the corner at the origin, two objects in the cells beside it.
void shutIn(Task& task) {
  World& world = task.initial;
  const ObjectState moved = world.objects[world.target];
  task.goal.cell = moved.cell == Cell{0, 0} ? Cell{2, 4} : moved.cell;
  world.objects[world.target].cell = {0, 0};
  std::vector<Cell> walls{{1, 0}, {0, 1}};
  for (std::size_t i = 0; i < world.objects.size(); ++i) {
    if (i != world.target && !walls.empty()) {
      world.objects[i].cell = walls.back();
      walls.pop_back();
    }
  }
  if (task.goal.cell == Cell{1, 0} || task.goal.cell == Cell{0, 1}) task.goal.cell = {2, 4};
  task.reference.clear();
}

World goalWorld(const Task& task) {
  World world = task.initial;
  for (const FurtherTarget& target : targetsOf(task)) world.objects[target.object] = target.goal;
  return world;
}

Scenario makeScenario(const ScenarioSetOptions& options, const std::string& name,
                      const Reference& reference, Renderer* renderer) {
  const Task& task = reference.task;
  Scenario scenario;
  scenario.name = name;
  scenario.model = options.model;
  const std::vector<FurtherTarget> targets = targetsOf(task);
  if (targets.size() == 1) {
    scenario.target = static_cast<std::uint8_t>(task.initial.target + 1);
  } else {
    for (const FurtherTarget& target : targets) {
      scenario.targets.push_back(static_cast<std::uint8_t>(target.object + 1));
    }
    scenario.planner.name = "astar";
  }
  if (renderer) {
    const Appearance appearance{task.appearance, options.domain};
    scenario.input = PictureInput{renderer->render(task.initial, appearance),
                                  renderer->render(goalWorld(task), appearance)};
    return scenario;
  }
  SymbolInput input;
  for (const ObjectState& object : task.initial.objects) {
    input.objects.push_back(symbolsOf(object, options.grounding));
  }
  input.goal = symbolsOf(task.goal, options.grounding);
  if (targets.size() > 1) {
    for (const FurtherTarget& target : targets) {
      input.goals.push_back(symbolsOf(target.goal, options.grounding));
    }
  }
  scenario.input = std::move(input);
  return scenario;
}

}  // namespace

std::string scenarioName(const ScenarioSetOptions& options, int i) {
  std::string number = std::to_string(i + 1);
  number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
  const std::string several = options.targets > 1 ? "x" + std::to_string(options.targets) : "";
  return (options.infeasible ? "infeasible"
                             : "level" + std::to_string(options.tasks.level) + several) +
         "-" + number;
}

Reference drawReference(const ScenarioSetOptions& options, int i) {
  if (options.targets > 1) return {drawTwoTargetTask(options.tasks, i), options.domain};
  TaskOptions tasks = options.tasks;
  if (options.infeasible) tasks.level = 2;
  Reference reference{TaskGenerator(tasks).task(i), options.domain};
  if (options.infeasible) shutIn(reference.task);
  return reference;
}

GivenSymbols symbolsOf(const ObjectState& object, const SymbolGrounding& grounding) {
  const std::array<int, kNumConcepts> values{static_cast<int>(object.type),
                                             object.cell.x,
                                             object.cell.y,
                                             object.rotation,
                                             object.color,
                                             object.size};
  GivenSymbols symbols;
  for (const Concept which : kConcepts) {
    symbols[index(which)] =
        symbolNamed(grounding, which, static_cast<std::size_t>(values[index(which)]));
  }
  return symbols;
}

std::vector<std::filesystem::path> generateScenarios(
    const std::filesystem::path& folder, const ScenarioSetOptions& options, int jobs,
    const std::function<void(std::size_t, std::size_t)>& progress,
    const std::atomic<bool>& cancel) {
  const auto total = static_cast<std::size_t>(options.count);
  std::vector<char> finished(total, 0);
  std::size_t done = 0;
  std::mutex mutex;
  progress(0, total);
  workInParallel(total, jobs, &cancel, [&]() -> Worker {
    const auto renderer =
        options.symbols_only ? std::shared_ptr<Renderer>() : std::make_shared<Renderer>();
    return [&, renderer](std::size_t i) {
      const std::string name = scenarioName(options, static_cast<int>(i));
      const Reference reference = drawReference(options, static_cast<int>(i));
      writeScenario(folder / name, makeScenario(options, name, reference, renderer.get()),
                    reference);
      const std::lock_guard lock(mutex);
      finished[i] = 1;
      progress(++done, total);
    };
  });
  std::vector<std::filesystem::path> folders;
  for (std::size_t i = 0; i < total; ++i) {
    if (finished[i]) folders.push_back(folder / scenarioName(options, static_cast<int>(i)));
  }
  return folders;
}

}  // namespace conceptplan::cli
