// Stands in for fast-downward.py: takes the same arguments, solves the PDDL with the tests' own
// reader and Dijkstra's algorithm, and writes the plan file.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>

#include "planners/pddl/pddl_task.hpp"

namespace {

std::string contents(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const auto plan_option = std::find(arguments.begin(), arguments.end(), "--plan-file");
  const auto domain = std::find(arguments.begin(), arguments.end(), "domain.pddl");
  if (arguments.end() - plan_option < 2 || arguments.end() - domain < 2) return 36;
  const conceptplan::testing::PddlTask task(contents(*domain), contents(*(domain + 1)));
  const auto solution = task.solve();
  if (!solution) return 11;
  std::ofstream plan(*(plan_option + 1));
  for (const std::string& step : solution->steps) plan << step << "\n";
  plan << "; cost = " << solution->cost << " (general cost)\n";
  std::cout << "[t=0s, 9 KB] Expanded " << solution->expanded << " state(s).\n";
  return 0;
}
