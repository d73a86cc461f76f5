// Planners against brute force on small random worlds: whatever they search by, what they answer is
// what trying everything answers.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <set>

#include "conceptplan/planners/belief_update.hpp"
#include "conceptplan/planners/planner_registry.hpp"
#include "planners/grid_world.hpp"
#include "planners/random_world.hpp"
#include "planners/tiny_world.hpp"

namespace conceptplan {
namespace {

using testing::randomWorld;

constexpr std::uint64_t kWorlds = 60;
constexpr double kThreshold = 0.01;
constexpr double kDiscount = 0.99;
constexpr std::size_t kHorizon = 6;
/// Costs are counted in billionths.
constexpr double kCostTolerance = 1e-7;

PlanQuery queryFor(std::size_t top, std::size_t horizon = kHorizon) {
  PlanQuery query;
  query.top = top;
  query.limits.horizon = horizon;
  return query;
}

PlanResult solve(const std::string& planner, const SymbolGraph& graph, const PlanQuery& query,
                 const OptionTexts& options = {}) {
  return PlannerRegistry::standard().make(planner, options)->solve(graph, query);
}

/// An action sequence in which every action has its most probable outcome.
struct Walk {
  double cost = 0;  ///< -log of its discounted probability
  ActionSequence actions;
};

/// All walks from the start to the goal of at most so many actions, each of them legal, valid and
/// changing something.
std::vector<Walk> allWalks(const SymbolGraph& graph, std::size_t horizon = kHorizon) {
  std::vector<Walk> walks;
  ActionSequence prefix;
  const std::function<void(StateId, double)> walk = [&](StateId state, double probability) {
    if (state == graph.mostProbableGoal()) walks.push_back({-std::log(probability), prefix});
    if (prefix.size() == horizon) return;
    for (const Action action : kActions) {
      if (graph.legality(state, action) <= kThreshold) continue;
      const Transition& outcome = graph.transitions(state, action).front();
      if (outcome.state == state || !graph.valid(outcome.state)) continue;
      prefix.push_back(action);
      walk(outcome.state, probability * kDiscount * outcome.probability);
      prefix.pop_back();
    }
  };
  walk(graph.mostProbableStart(), 1);
  std::sort(walks.begin(), walks.end(),
            [](const Walk& a, const Walk& b) { return a.cost < b.cost; });
  return walks;
}

/// Every plan is a walk and costs what it costs; rising, none twice.
void expectWalks(const PlanResult& result, const std::vector<Walk>& walks) {
  std::set<ActionSequence> distinct;
  double last = 0;
  for (const Plan& plan : result.plans) {
    const auto same = std::find_if(walks.begin(), walks.end(),
                                   [&](const Walk& walk) { return walk.actions == plan.actions; });
    ASSERT_NE(same, walks.end());
    EXPECT_NEAR(plan.cost, same->cost, kCostTolerance);
    EXPECT_GE(plan.cost, last);
    last = plan.cost;
    EXPECT_TRUE(distinct.insert(plan.actions).second);
  }
}

class ExactPaths : public ::testing::TestWithParam<const char*> {};

// The k shortest paths problem (Eppstein 1998), against full enumeration.
TEST_P(ExactPaths, AreTheBestOfFullEnumerationInOrder) {
  constexpr std::size_t kTop = 25;
  std::size_t solved = 0;
  for (std::uint64_t seed = 0; seed < kWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed);
    const std::vector<Walk> walks = allWalks(graph);
    const PlanResult result = solve(GetParam(), graph, queryFor(kTop));
    ASSERT_EQ(result.status, walks.empty() ? PlanStatus::kInfeasible : PlanStatus::kSolved);
    ASSERT_EQ(result.plans.size(), std::min(kTop, walks.size()));
    expectWalks(result, walks);
    for (std::size_t i = 0; i < result.plans.size(); ++i) {
      EXPECT_NEAR(result.plans[i].cost, walks[i].cost, kCostTolerance) << "plan " << i;
    }
    solved += walks.empty() ? 0 : 1;
  }
  EXPECT_GT(solved, kWorlds / 3);
  EXPECT_LT(solved, kWorlds);
}

INSTANTIATE_TEST_SUITE_P(Planners, ExactPaths, ::testing::Values("dijkstra", "astar", "kbest"),
                         [](const auto& planner) { return std::string(planner.param); });

// Korf 1985: the first solution of iterative deepening with a consistent heuristic is the best one.
TEST(IdaStarOracle, ThePlanIsTheBestOfFullEnumeration) {
  for (std::uint64_t seed = 0; seed < kWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed);
    const std::vector<Walk> walks = allWalks(graph);
    const PlanResult result = solve("idastar", graph, queryFor(1));
    ASSERT_EQ(result.status, walks.empty() ? PlanStatus::kInfeasible : PlanStatus::kSolved);
    if (walks.empty()) continue;
    expectWalks(result, walks);
    EXPECT_NEAR(result.plans.front().cost, walks.front().cost, kCostTolerance);
  }
}

// Moore 1959: breadth-first search finds the shortest paths.
TEST(BfsOracle, PlansAreTheShortestOfFullEnumerationThenByTheOrderOfActions) {
  constexpr std::size_t kTop = 25;
  for (std::uint64_t seed = 0; seed < kWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed);
    std::vector<Walk> walks = allWalks(graph);
    std::sort(walks.begin(), walks.end(), [](const Walk& a, const Walk& b) {
      return std::pair(a.actions.size(), a.actions) < std::pair(b.actions.size(), b.actions);
    });
    const PlanResult result = solve("bfs", graph, queryFor(kTop));
    ASSERT_EQ(result.plans.size(), std::min(kTop, walks.size()));
    for (std::size_t i = 0; i < result.plans.size(); ++i) {
      EXPECT_EQ(result.plans[i].actions, walks[i].actions) << "plan " << i;
    }
  }
}

class FindingPlanner : public ::testing::TestWithParam<const char*> {};

// Nilsson 1980: a best-first search with any evaluation is complete on a finite graph.
TEST_P(FindingPlanner, FindsAPlanWhereverOneIs) {
  for (std::uint64_t seed = 0; seed < kWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed);
    const std::vector<Walk> walks = allWalks(graph);
    const PlanResult result = solve(GetParam(), graph, queryFor(5));
    ASSERT_EQ(result.status, walks.empty() ? PlanStatus::kInfeasible : PlanStatus::kSolved);
    expectWalks(result, walks);
  }
}

INSTANTIATE_TEST_SUITE_P(Planners, FindingPlanner, ::testing::Values("greedy", "beam"),
                         [](const auto& planner) { return std::string(planner.param); });

// Lowerre 1976: a beam search keeps so many candidates a length and is not complete.
TEST(BeamOracle, TooNarrowABeamGivesUpInsteadOfProving) {
  std::size_t given_up = 0;
  for (std::uint64_t seed = 0; seed < kWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed);
    const std::vector<Walk> walks = allWalks(graph);
    const PlanResult result = solve("beam", graph, queryFor(1), {{"width", "1"}});
    EXPECT_TRUE(result.status != PlanStatus::kInfeasible || walks.empty());
    if (result.status == PlanStatus::kSolved) expectWalks(result, walks);
    if (result.status != PlanStatus::kLimit) continue;
    ++given_up;
    EXPECT_THAT(result.reason, ::testing::HasSubstr("width of 1 sequences"));
  }
  EXPECT_GT(given_up, 0u);
}

/// V_n of Bellman's equation, n steps before the end, started from 0: the greatest probability of
/// the goal times the discount of each step, when the state can be seen.
std::vector<double> valuesByBackwardInduction(const SymbolGraph& graph, std::size_t steps) {
  std::vector<double> values(graph.numStates(), 0);
  for (std::size_t step = 0; step <= steps; ++step) {
    std::vector<double> before(graph.numStates(), 0);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto state = static_cast<StateId>(i);
      for (const Action action : kActions) {
        if (graph.legality(state, action) <= kThreshold) continue;
        double sum = 0;
        for (const Transition& outcome : graph.transitions(state, action)) {
          if (graph.valid(outcome.state)) sum += outcome.probability * values[index(outcome.state)];
        }
        before[i] = std::max(before[i], kDiscount * sum);
      }
    }
    before[index(graph.mostProbableGoal())] = 1;
    values = std::move(before);
  }
  return values;
}

/// The value of the start by what a planner says of its best plan, whose cost is -log of it where
/// the plan follows the policy.
double valueOfStart(const PlanResult& result) { return std::exp(-result.plans.front().cost); }

class PolicyPlanner : public ::testing::TestWithParam<const char*> {};

// Bellman 1957.
TEST_P(PolicyPlanner, TheValueOfTheStartSolvesBellmansEquation) {
  std::size_t solved = 0;
  for (std::uint64_t seed = 0; seed < kWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed);
    const double value = valuesByBackwardInduction(graph, 1500)[index(graph.mostProbableStart())];
    const PlanResult result = solve(GetParam(), graph, queryFor(5, 24));
    if (value == 0) {
      EXPECT_EQ(result.status, PlanStatus::kInfeasible);
      continue;
    }
    if (result.status == PlanStatus::kLimit) {
      EXPECT_THAT(result.reason, ::testing::HasSubstr("outcomes on which the policy rests"));
      continue;
    }
    ASSERT_EQ(result.status, PlanStatus::kSolved) << result.reason;
    EXPECT_LE(valueOfStart(result), value + 2e-4);
    solved += std::abs(valueOfStart(result) - value) < 2e-4 ? 1 : 0;
  }
  // In few worlds no plan follows the policy, and the best plan costs more than that.
  EXPECT_GT(solved, kWorlds / 3);
}

/// The value of one stationary policy, [states].
std::vector<double> valuesOfPolicy(const SymbolGraph& graph, const std::vector<Action>& policy) {
  std::vector<double> values(graph.numStates(), 0);
  for (int sweep = 0; sweep < 200; ++sweep) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto state = static_cast<StateId>(i);
      double value = state == graph.mostProbableGoal() ? 1 : 0;
      if (value == 0 && graph.legality(state, policy[i]) > kThreshold) {
        for (const Transition& outcome : graph.transitions(state, policy[i])) {
          value += kDiscount * outcome.probability * values[index(outcome.state)];
        }
      }
      values[i] = value;
    }
  }
  return values;
}

// Bellman 1957: some stationary policy is as good as any other from every state.
TEST_P(PolicyPlanner, TheValueOfTheStartIsThatOfTheBestOfAllPolicies) {
  using testing::tinySymbols;
  const SymbolGraph graph = compile(
      testing::tinyModel(), testing::tinyProblem(tinySymbols(0, 0, 0, 0), tinySymbols(0, 2, 1, 0)),
      GridValidity());
  constexpr std::array kChoices{Action::kMoveLeft, Action::kMoveRight, Action::kRotateLeft};
  ASSERT_EQ(graph.numStates(), 6u);
  double best = 0;
  for (std::size_t code = 0; code < 3 * 3 * 3 * 3 * 3 * 3; ++code) {
    std::vector<Action> policy;
    for (std::size_t rest = code, i = 0; i < 6; ++i, rest /= 3) {
      policy.push_back(kChoices[rest % 3]);
    }
    best = std::max(best, valuesOfPolicy(graph, policy)[index(graph.mostProbableStart())]);
  }
  const PlanResult result = solve(GetParam(), graph, queryFor(3, 24));
  ASSERT_EQ(result.status, PlanStatus::kSolved);
  EXPECT_NEAR(valueOfStart(result), best, 1e-5);
  // Open loop, a plan cannot react to a slip: two moves right at 0.8 and a turn at 0.9.
  EXPECT_NEAR(result.plans.front().probability, 0.8 * 0.8 * 0.9, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Planners, PolicyPlanner, ::testing::Values("value-iteration", "lrtdp"),
                         [](const auto& planner) {
                           std::string name = planner.param;
                           std::erase(name, '-');
                           return name;
                         });

// Kocsis and Szepesvari 2006: the values of UCT tend to those of the best policy.
TEST(MctsOracle, TheFirstActionIsNearlyTheBestAfterManyRuns) {
  std::size_t solved = 0;
  for (std::uint64_t seed = 0; seed < kWorlds / 3; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed);
    const StateId start = graph.mostProbableStart();
    const std::vector<double> values = valuesByBackwardInduction(graph, 1500);
    if (values[index(start)] == 0 || start == graph.mostProbableGoal()) continue;
    const PlanResult result = solve("mcts", graph, queryFor(1, 24), {{"iterations", "1000"}});
    if (result.status != PlanStatus::kSolved) continue;
    double value = 0;
    for (const Transition& outcome :
         graph.transitions(start, result.plans.front().actions.front())) {
      if (!graph.valid(outcome.state)) continue;
      value += kDiscount * outcome.probability * values[index(outcome.state)];
    }
    EXPECT_GE(value, values[index(start)] - 0.1);
    ++solved;
  }
  EXPECT_GT(solved, kWorlds / 10);
}

TEST(MctsOracle, TheSeedDecidesTheRuns) {
  std::size_t differing = 0;
  for (std::uint64_t world = 0; world < kWorlds / 3; ++world) {
    SCOPED_TRACE(world);
    const SymbolGraph graph = randomWorld(world);
    PlanQuery query = queryFor(5, 24);
    query.seed = 1;
    const PlanResult result = solve("mcts", graph, query);
    EXPECT_EQ(result, solve("mcts", graph, query));
    query.seed = 2;
    differing += solve("mcts", graph, query) != result ? 1 : 0;
  }
  EXPECT_GT(differing, 0u);
}

/// One reading of the paper's reasoner.
struct BeliefCase {
  const char* name;
  bool hard;  ///< most probable symbols alone
  bool conditional;
  double step_discount;
};

void PrintTo(const BeliefCase& c, std::ostream* out) { *out << c.name; }

/// Start and goal as the case takes them, [states].
struct BeliefEnds {
  StateBelief start;
  StateBelief goal;
};

BeliefEnds endsOf(const SymbolGraph& graph, const BeliefCase& c) {
  if (c.hard) {
    BeliefEnds ends{StateBelief(graph.numStates(), 0), StateBelief(graph.numStates(), 0)};
    ends.start[index(graph.mostProbableStart())] = 1;
    ends.goal[index(graph.mostProbableGoal())] = 1;
    return ends;
  }
  BeliefEnds ends{graph.stateBelief(graph.initialBelief()),
                  graph.stateBelief(graph.problem().goal)};
  double valid = 0;
  for (std::size_t i = 0; i < ends.start.size(); ++i) {
    if (!graph.valid(static_cast<StateId>(i))) ends.start[i] = 0;
    valid += ends.start[i];
  }
  for (double& mass : ends.start) mass /= valid;
  return ends;
}

/// What is summed over all sequences of states along which every step is legal and valid.
struct PathSums {
  double survived = 0;  ///< Pr[sequence]
  double reached = 0;   ///< Pr[sequence] Pr[its end is the goal]
};

void addPaths(const SymbolGraph& graph, const StateBelief& goal, const ActionSequence& actions,
              std::size_t step, StateId state, double probability, PathSums& sums) {
  if (step == actions.size()) {
    sums.survived += probability;
    sums.reached += probability * goal[index(state)];
    return;
  }
  if (graph.legality(state, actions[step]) <= kThreshold) return;
  for (const Transition& outcome : graph.transitions(state, actions[step])) {
    if (!graph.valid(outcome.state)) continue;
    addPaths(graph, goal, actions, step + 1, outcome.state, probability * outcome.probability,
             sums);
  }
}

/// An action sequence and the score by which the case ranks it.
struct RankedSequence {
  double score;
  ActionSequence actions;
};

StateBelief updated(const SymbolGraph& graph, const StateBelief& belief, Action action,
                    bool conditional) {
  StateBelief next = propagateLegal(graph, belief, action, kThreshold);
  keepValid(graph, next);
  if (conditional) normalize(next);
  return next;
}

bool isSame(const StateBelief& a, const StateBelief& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i] - b[i]) > 1e-12) return false;
  }
  return true;
}

/// All sequences that may reach the goal, best first, but for those with an action that leaves the
/// belief as it is.
std::vector<RankedSequence> allRanked(const SymbolGraph& graph, const BeliefCase& c,
                                      std::size_t longest) {
  const BeliefEnds ends = endsOf(graph, c);
  std::vector<RankedSequence> ranked;
  ActionSequence prefix;
  const std::function<void(const StateBelief&)> enumerate = [&](const StateBelief& belief) {
    PathSums sums;
    for (std::size_t i = 0; i < ends.start.size(); ++i) {
      if (ends.start[i] == 0) continue;
      addPaths(graph, ends.goal, prefix, 0, static_cast<StateId>(i), ends.start[i], sums);
    }
    const double probability = c.conditional ? sums.reached / sums.survived : sums.reached;
    if (sums.reached > 0) {
      ranked.push_back({std::pow(1 - c.step_discount, prefix.size()) * probability, prefix});
    }
    if (prefix.size() == longest) return;
    for (const Action action : kActions) {
      const StateBelief next = updated(graph, belief, action, c.conditional);
      if (isSame(next, belief)) continue;
      prefix.push_back(action);
      enumerate(next);
      prefix.pop_back();
    }
  };
  enumerate(ends.start);
  std::sort(ranked.begin(), ranked.end(),
            [](const RankedSequence& a, const RankedSequence& b) { return a.score > b.score; });
  return ranked;
}

class BeliefOracle : public ::testing::TestWithParam<BeliefCase> {};

// Eqs. (4)-(6) of arXiv 2310.03325, Sec. III-B. That the belief is scaled to one after each step
// divides what reaches the goal by all that has survived.
TEST_P(BeliefOracle, Eqs4To6BySummationOverAllStatePathsOfAllSequences) {
  constexpr std::size_t kLongest = 3;
  const BeliefCase& c = GetParam();
  const OptionTexts options{{"alternatives", "paths"},
                            {"min_hypothesis", "0"},
                            {"min_probability", "0"},
                            {"symbols", c.hard ? "hard" : "soft"},
                            {"ranking", c.conditional ? "conditional" : "joint"},
                            {"step_discount", c.step_discount == 0 ? "0" : "0.01"}};
  std::size_t solved = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    const SymbolGraph graph = randomWorld(seed, true);
    const std::vector<RankedSequence> all = allRanked(graph, c, kLongest);
    solved += all.empty() ? 0 : 1;
    for (const std::size_t top : {1u, 3u, 10u}) {
      const PlanResult result = solve("belief", graph, queryFor(top, kLongest), options);
      ASSERT_EQ(result.status, all.empty() ? PlanStatus::kInfeasible : PlanStatus::kSolved);
      ASSERT_EQ(result.plans.size(), std::min(top, all.size())) << result.reason;
      for (std::size_t i = 0; i < result.plans.size(); ++i) {
        EXPECT_NEAR(std::exp(-result.plans[i].cost), all[i].score, 1e-9) << "plan " << i;
      }
      if (all.empty()) continue;
      std::size_t fewest = kLongest;
      for (const RankedSequence& sequence : all) {
        if (sequence.score < all.front().score * (1 - 1e-11)) break;
        fewest = std::min(fewest, sequence.actions.size());
      }
      EXPECT_EQ(result.plans.front().actions.size(), fewest);
    }
  }
  EXPECT_GT(solved, 4u);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, BeliefOracle,
    ::testing::Values(BeliefCase{"SoftJoint", false, false, 0.01},
                      BeliefCase{"SoftConditional", false, true, 0.01},
                      BeliefCase{"HardJoint", true, false, 0.01},
                      BeliefCase{"HardConditional", true, true, 0.01},
                      BeliefCase{"SoftJointUndiscounted", false, false, 0},
                      BeliefCase{"SoftConditionalUndiscounted", false, true, 0},
                      BeliefCase{"HardJointUndiscounted", true, false, 0},
                      BeliefCase{"HardConditionalUndiscounted", true, true, 0}),
    [](const auto& c) { return std::string(c.param.name); });

// Where every outcome is sure all ways to the goal are equally probable, and wandering costs
// nothing without a discount.
TEST(BeliefPlannerOracle, WithoutADiscountThePlansAreTheShortestOnes) {
  for (const char* ranking : {"joint", "conditional"}) {
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      SCOPED_TRACE(seed);
      const testing::GridWorld world = testing::gridWorld(3, 3, 4, 0.1, seed);
      const SymbolGraph graph = compile(world.model, world.problem, GridValidity());
      const PlanResult shortest = solve("bfs", graph, queryFor(5, 24));
      if (shortest.status != PlanStatus::kSolved) continue;
      for (const std::size_t longer : {0u, 1u, 18u}) {
        const std::size_t horizon = shortest.plans.front().actions.size() + longer;
        const PlanResult result = solve("belief", graph, queryFor(5, horizon),
                                        {{"step_discount", "0"}, {"ranking", ranking}});
        ASSERT_EQ(result.status, PlanStatus::kSolved) << result.reason;
        EXPECT_EQ(result.plans.front().actions.size(), shortest.plans.front().actions.size());
        EXPECT_NEAR(result.plans.front().probability, 1, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace conceptplan
