// Reads two pictures of a workbench, plans, and draws what each step will look like. The arguments
// are what the names of the pictures' files begin with.
#include <conceptplan/domain/files/rgbd_image_file.hpp>
#include <conceptplan/fcl/fcl_validity.hpp>
#include <conceptplan/pipeline/solve.hpp>
#include <conceptplan/planners/belief_planner.hpp>
#include <iostream>

using namespace conceptplan;

int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("expected two pictures");
  const RgbdImage picture = readRgbdImage(rgbdPaths(argv[1]));
  const Model model(findModel("default"));
  const TaskReading read = model.readTask(picture, readRgbdImage(rgbdPaths(argv[2])));

  for (const SymbolBelief& belief : read.initial.beliefs) {
    const Symbols symbols = mostProbable(belief);
    for (const Concept which : kConcepts) {
      const SymbolId symbol = symbols[index(which)];
      std::cout << model.symbolic().grounding.name(which, symbol) << " ("
                << belief[index(which)][index(symbol)] << ") ";
    }
    std::cout << '\n';
  }

  const SymbolicProblem problem = problemOf(read.initial, read.goal, std::nullopt);
  const SymbolGraph graph = compile(model.symbolic(), problem, FclValidity());
  const PlanResult result = BeliefPlanner().solve(graph, {});
  if (result.plans.empty()) throw std::runtime_error(result.reason);
  const std::uint8_t target = read.initial.instances[problem.initial.target];
  const auto frames = model.render(picture, read.initial, target, result.plans.front());
  for (std::size_t step = 0; step < frames.size(); ++step) {
    writeRgbdImage("step-" + std::to_string(step + 1), frames[step]);
  }
  std::cout << frames.size() << " pictures\n";
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
