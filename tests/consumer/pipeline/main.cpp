// From two pictures of a workbench to plans and a report: the arguments are what the names of the
// pictures' files begin with, e.g. scenarios/level1-0001/initial scenarios/level1-0001/goal.
#include <conceptplan/domain/files/rgbd_image_file.hpp>
#include <conceptplan/pipeline/solve.hpp>
#include <conceptplan/planners/belief_planner.hpp>
#include <iostream>

using namespace conceptplan;

int main(int argc, char** argv) try {
  if (argc != 3) throw std::invalid_argument("expected two pictures");
  Scenario scenario;
  scenario.name = "two pictures";
  scenario.input =
      PictureInput{readRgbdImage(rgbdPaths(argv[1])), readRgbdImage(rgbdPaths(argv[2]))};

  const Model model(findModel(scenario.model));
  const Solution solution = solveScenario(scenario, model, BeliefPlanner());
  for (const Plan& plan : solution.result.plans) {
    std::cout << plan.probability;
    for (const Action action : plan.actions) std::cout << ' ' << name(action);
    std::cout << '\n';
  }
  writeReport("report.html", reportOf(scenario, model, solution, "belief", 0));
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
