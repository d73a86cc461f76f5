#include "conceptplan/planners/belief_planner.hpp"
#include "conceptplan/planners/bfs_planner.hpp"
#include "conceptplan/planners/planner_registry.hpp"

namespace conceptplan {
namespace {

PlannerOption number(std::string name, std::string standard, double least, double most,
                     std::string summary) {
  return {std::move(name),   OptionType::kNumber, std::move(standard), least, most, {},
          std::move(summary)};
}

PlannerOption choice(std::string name, std::vector<std::string> choices, std::string summary) {
  std::string standard = choices.front();
  return {std::move(name),    OptionType::kChoice, std::move(standard), 0, 0,
          std::move(choices), std::move(summary)};
}

PlannerOption legalityThreshold() {
  return number("legality_threshold", "0.01", 0, 1,
                "an action is legal where Pr[a given the symbols] is greater");
}

PlannerEntry beliefEntry() {
  return {
      "belief",
      "Most probable action sequences under a belief over symbols, with both legality checks.",
      "arXiv 2310.03325, Sec. III-B, Eqs. (4)-(6); the search orders beliefs by the bound of QMDP "
      "(Littman, Cassandra and Kaelbling, 1995, doi:10.1016/b978-1-55860-377-6.50052-9).",
      {"Plans are distinct and ordered by probability, discounted by step_discount an action; ties "
       "go to the shorter plan, then to the order of the actions.",
       "The first plan is the best one within the horizon, up to start states "
       "below min_hypothesis; a search stopped by a limit says so.",
       "infeasible is proved on the compiled graph; giving up is limit or timeout."},
      {legalityThreshold(),
       choice("symbols", {"soft", "hard"},
              "plan with the whole belief, or with the most probable symbols alone"),
       choice("ranking", {"joint", "conditional"},
              "probability of the goal and of every step, or of the goal under the belief that is "
              "scaled to one at each step (the paper's letter)"),
       choice("alternatives", {"outcomes", "paths"},
              "further plans lead to other outcomes first, or are the next most probable sequences "
              "whatever their outcome"),
       number("step_discount", "0.01", 0, 0.5,
              "share by which one more action must raise a plan's probability to rank first"),
       number("min_probability", "0.001", 0, 1,
              "least probability of a plan where the most probable goal is out of reach"),
       number("min_hypothesis", "0.0001", 0, 1,
              "start states with a smaller share of the most probable one do not guide the search"),
       number(
           "alternative_share", "0.01", 0, 1,
           "other outcomes with a smaller share of the best plan's probability give way to other "
           "paths")},
      [](const OptionValues& values) -> std::unique_ptr<Planner> {
        BeliefPlannerOptions options;
        options.legality_threshold = values.number("legality_threshold");
        options.hard_symbols = values.choice("symbols") == "hard";
        options.ranking =
            values.choice("ranking") == "joint" ? Ranking::kJoint : Ranking::kConditional;
        options.alternatives = values.choice("alternatives") == "outcomes" ? Alternatives::kOutcomes
                                                                           : Alternatives::kPaths;
        options.step_discount = values.number("step_discount");
        options.min_probability = values.number("min_probability");
        options.min_hypothesis = values.number("min_hypothesis");
        options.alternative_share = values.number("alternative_share");
        return std::make_unique<BeliefPlanner>(options);
      }};
}

PlannerEntry bfsEntry() {
  return {
      "bfs",
      "Fewest actions from the most probable start to the most probable goal.",
      "E. F. Moore, The shortest path through a maze, 1959.",
      {"Plans are distinct and ordered by length, then by the order of the actions.",
       "The first plan has the fewest actions among those in which every action has its most "
       "probable outcome.",
       "infeasible is proved on the compiled graph; giving up is limit or timeout."},
      {legalityThreshold()},
      [](const OptionValues& values) -> std::unique_ptr<Planner> {
        return std::make_unique<BfsPlanner>(BfsPlannerOptions{values.number("legality_threshold")});
      }};
}

}  // namespace

PlannerRegistry PlannerRegistry::standard() {
  PlannerRegistry registry;
  registry.add(beliefEntry());
  registry.add(bfsEntry());
  return registry;
}

}  // namespace conceptplan
