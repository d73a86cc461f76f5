#include "conceptplan/planners/beam_planner.hpp"
#include "conceptplan/planners/belief_planner.hpp"
#include "conceptplan/planners/best_first_planner.hpp"
#include "conceptplan/planners/bfs_planner.hpp"
#include "conceptplan/planners/idastar_planner.hpp"
#include "conceptplan/planners/lrtdp_planner.hpp"
#include "conceptplan/planners/mcts_planner.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "conceptplan/planners/value_iteration_planner.hpp"

namespace conceptplan {
namespace {

constexpr double kMostCount = 100'000;

PlannerOption epsilon(std::string summary) {
  return PlannerOption::number("epsilon", "1e-6", 1e-12, 0.1, std::move(summary));
}

/// What planners that give every action its most probable outcome say of giving up.
const char* const kProvedOnLikelyOutcomes =
    "infeasible is proved for plans in which every action has its most probable outcome; giving up "
    "is limit or timeout.";

/// What planners of the Markov decision process say of giving up.
const char* const kProvedOnAllOutcomes =
    "infeasible is proved for all outcomes of all legal actions; giving up is limit or timeout; "
    "limit also if the goal can be reached, but not along the outcomes on which the policy rests.";

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
       "infeasible is proved on the compiled graph; giving up is limit or timeout; limit also if "
       "no "
       "plan was found, but sequences of a discounted probability below 1e-12, or start states "
       "below min_hypothesis from which the goal may be in reach, were left out."},
      {PlannerOption::legalityThreshold(),
       PlannerOption::choice("symbols", {"soft", "hard"},
                             "plan with the whole belief, or with the most probable symbols alone"),
       PlannerOption::choice(
           "ranking", {"joint", "conditional"},
           "probability of the goal and of every step, or of the goal under the belief that is "
           "scaled to one at each step (the paper's letter)"),
       PlannerOption::choice(
           "alternatives", {"outcomes", "paths"},
           "further plans lead to other outcomes first, or are the next most probable sequences "
           "whatever their outcome"),
       PlannerOption::stepDiscount(),
       PlannerOption::number(
           "min_probability", "0.001", 0, 1,
           "least probability of a plan where the most probable goal is out of reach"),
       PlannerOption::number(
           "min_hypothesis", "0.0001", 0, 1,
           "start states with a smaller share of the most probable one do not guide the search"),
       PlannerOption::number(
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

/// What planners say that search for several targets too.
const char* const kBestForSeveral =
    "Plans also for several targets, of which each action moves one: the best ones within the "
    "horizon times the number of targets. Plans in which each target has the same actions count "
    "as one.";
const char* const kGreedyForSeveral =
    "Plans also for several targets, of which each action moves one, within the horizon times the "
    "number of targets.";

PlannerEntry bfsEntry() {
  return {
      "bfs",
      "Fewest actions from the most probable start to the most probable goal.",
      "E. F. Moore, The shortest path through a maze, 1959.",
      {"Plans are distinct and ordered by length, then by the order of the actions.",
       "The first plan has the fewest actions among those in which every action has its most "
       "probable outcome.",
       kProvedOnLikelyOutcomes, kBestForSeveral},
      {PlannerOption::legalityThreshold()},
      [](const OptionValues& values) -> std::unique_ptr<Planner> {
        return std::make_unique<BfsPlanner>(BfsPlannerOptions{values.number("legality_threshold")});
      },
      [](const OptionValues& values) {
        JointPlannerOptions options;
        options.legality_threshold = values.number("legality_threshold");
        options.count_actions = true;
        return JointPlanner(options);
      }};
}

/// The joint search of the same guidance; none for the exact distances, which it does not know.
std::function<JointPlanner(const OptionValues&)> jointSearch(Guidance guidance, bool greedy) {
  if (guidance == Guidance::kDistances) return {};
  return [guidance, greedy](const OptionValues& values) {
    JointPlannerOptions options;
    options.legality_threshold = values.number("legality_threshold");
    options.step_discount = values.number("step_discount");
    options.guided = guidance != Guidance::kNone;
    options.greedy = greedy;
    return JointPlanner(options);
  };
}

/// The planners of BestFirstPlanner differ in how they are guided.
PlannerEntry bestFirstEntry(std::string name, std::string summary, std::string source,
                            std::vector<std::string> guarantees, Guidance guidance, bool greedy) {
  guarantees.push_back(kProvedOnLikelyOutcomes);
  if (guidance != Guidance::kDistances) {
    guarantees.push_back(greedy ? kGreedyForSeveral : kBestForSeveral);
  }
  return {std::move(name),
          std::move(summary),
          std::move(source),
          std::move(guarantees),
          {PlannerOption::legalityThreshold(), PlannerOption::stepDiscount()},
          [guidance, greedy](const OptionValues& values) -> std::unique_ptr<Planner> {
            BestFirstPlannerOptions options;
            options.legality_threshold = values.number("legality_threshold");
            options.step_discount = values.number("step_discount");
            options.guidance = guidance;
            options.greedy = greedy;
            return std::make_unique<BestFirstPlanner>(options);
          },
          jointSearch(guidance, greedy)};
}

/// What all exact planners over most probable outcomes promise of their plans.
const char* const kExactPlans =
    "The plans are exactly the best ones within the horizon, distinct and by rising cost; the cost "
    "of a step is -log Pr[its most probable outcome] - log(1 - step_discount), counted in "
    "billionths; ties go to the shorter plan.";

PlannerEntry dijkstraEntry() {
  return bestFirstEntry("dijkstra", "Most probable paths by uniform-cost search, without guidance.",
                        "E. W. Dijkstra, A note on two problems in connexion with graphs, 1959, "
                        "doi:10.1007/BF01386390.",
                        {kExactPlans}, Guidance::kNone, false);
}

PlannerEntry astarEntry() {
  return bestFirstEntry(
      "astar", "Most probable paths, guided by a lower bound of the cost from the learned tables.",
      "P. E. Hart, N. J. Nilsson and B. Raphael, 1968, doi:10.1109/TSSC.1968.300136; the bound "
      "sums "
      "one projection a concept (J. Culberson and J. Schaeffer, 1998, doi:10.1111/0824-7935.00065; "
      "M. Katz and C. Domshlak, 2010, doi:10.1016/j.artint.2010.04.021).",
      {kExactPlans, "The bound is admissible and consistent."}, Guidance::kProjections, false);
}

PlannerEntry greedyEntry() {
  return bestFirstEntry(
      "greedy", "Paths found by going where the lower bound of astar is least.",
      "J. E. Doran and D. Michie, Experiments with the graph traverser program, 1966, "
      "doi:10.1098/rspa.1966.0205.",
      {"Plans are distinct and by rising cost, as for dijkstra; none need be the best.",
       "A plan is found if there is one within the horizon."},
      Guidance::kProjections, true);
}

PlannerEntry kbestEntry() {
  return bestFirstEntry(
      "kbest", "Most probable paths in order, guided by the exact distance to the goal.",
      "D. Eppstein, Finding the k shortest paths, 1998, doi:10.1137/S0097539795290477, for the "
      "problem; best-first over paths behind one backward search.",
      {kExactPlans, "Paths may pass a state twice."}, Guidance::kDistances, false);
}

PlannerEntry idaStarEntry() {
  return {
      "idastar",
      "The most probable path by depth-first searches under a rising bound of cost.",
      "R. E. Korf, 1985, doi:10.1016/0004-3702(85)90084-0; A. Reinefeld and T. A. Marsland, 1994, "
      "doi:10.1109/34.297950; M. Helmert et al., 2019, doi:10.24963/ijcai.2019/174.",
      {"One plan, the best one within the horizon; cost as for dijkstra. If a limit strikes, the "
       "best plan found so far.",
       kProvedOnLikelyOutcomes},
      {PlannerOption::legalityThreshold(), PlannerOption::stepDiscount()},
      [](const OptionValues& values) -> std::unique_ptr<Planner> {
        return std::make_unique<IdaStarPlanner>(IdaStarPlannerOptions{
            values.number("legality_threshold"), values.number("step_discount")});
      }};
}

PlannerEntry beamEntry() {
  return {"beam",
          "Paths that grow together, of which only the most promising of each length go on.",
          "B. T. Lowerre, The HARPY speech recognition system, 1976.",
          {"Plans are distinct and by rising cost, as for dijkstra; none need be the best.",
           "At most width sequences of each length; limit if these were too few to find a plan.",
           kProvedOnLikelyOutcomes},
          {PlannerOption::legalityThreshold(), PlannerOption::stepDiscount(),
           PlannerOption::integer("width", "500", 1, kMostCount,
                                  "action sequences kept of each length")},
          [](const OptionValues& values) -> std::unique_ptr<Planner> {
            return std::make_unique<BeamPlanner>(BeamPlannerOptions{
                values.number("legality_threshold"), values.number("step_discount"),
                static_cast<std::size_t>(values.number("width"))});
          }};
}

/// What planners of the Markov decision process say of their plans.
const char* const kPolicyPlans =
    "Plans are distinct and by rising cost: -log of the value of the start, and for each step the "
    "logarithm by which its action falls short of the best one; a plan follows the outcome on "
    "which "
    "the value of each action rests most.";

PlannerEntry valueIterationEntry() {
  return {
      "value-iteration",
      "Sequences of the policy of greatest discounted probability of the goal, all outcomes "
      "counted.",
      "R. Bellman, A Markovian decision process, 1957.",
      {"The value of every state is that of the best policy to within epsilon, if symbols could be "
       "seen after each action: the expected (1 - step_discount)^steps over runs that reach the "
       "goal.",
       kPolicyPlans, kProvedOnAllOutcomes},
      {PlannerOption::legalityThreshold(), PlannerOption::stepDiscount(1e-4),
       epsilon("largest error of a value")},
      [](const OptionValues& values) -> std::unique_ptr<Planner> {
        return std::make_unique<ValueIterationPlanner>(
            ValueIterationPlannerOptions{values.number("legality_threshold"),
                                         values.number("step_discount"), values.number("epsilon")});
      }};
}

PlannerEntry lrtdpEntry() {
  return {
      "lrtdp",
      "As value-iteration, with values only where the best policy leads.",
      "B. Bonet and H. Geffner, Labeled RTDP, ICAPS 2003.",
      {"The value of the start is that of the best policy to within epsilon / step_discount; other "
       "values are upper bounds, by which the plans after the first are ordered.",
       kPolicyPlans, kProvedOnAllOutcomes},
      {PlannerOption::legalityThreshold(), PlannerOption::stepDiscount(1e-4),
       epsilon("change of a value below which a state is solved")},
      [](const OptionValues& values) -> std::unique_ptr<Planner> {
        return std::make_unique<LrtdpPlanner>(
            LrtdpPlannerOptions{values.number("legality_threshold"), values.number("step_discount"),
                                values.number("epsilon")});
      }};
}

PlannerEntry mctsEntry() {
  return {
      "mcts",
      "As value-iteration, with values estimated by simulated runs.",
      "L. Kocsis and C. Szepesvari, Bandit based Monte-Carlo planning, 2006, "
      "doi:10.1007/11871842_29.",
      {"Values tend to those of the best policy as iterations grow; no plan need be the best.",
       kPolicyPlans, kProvedOnAllOutcomes},
      {PlannerOption::legalityThreshold(), PlannerOption::stepDiscount(1e-4),
       PlannerOption::integer("iterations", "500", 1, kMostCount,
                              "simulated runs; each is one expansion"),
       PlannerOption::number("exploration", "0.1", 0, 10, "weight of the confidence bound")},
      [](const OptionValues& values) -> std::unique_ptr<Planner> {
        return std::make_unique<MctsPlanner>(MctsPlannerOptions{
            values.number("legality_threshold"), values.number("step_discount"),
            static_cast<std::size_t>(values.number("iterations")), values.number("exploration")});
      }};
}

}  // namespace

PlannerRegistry PlannerRegistry::standard() {
  PlannerRegistry registry;
  for (const auto entry :
       {beliefEntry, bfsEntry, dijkstraEntry, astarEntry, greedyEntry, kbestEntry, idaStarEntry,
        beamEntry, valueIterationEntry, lrtdpEntry, mctsEntry}) {
    registry.add(entry());
  }
  return registry;
}

}  // namespace conceptplan
