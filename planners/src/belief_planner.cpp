#include "conceptplan/planners/belief_planner.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "belief_search.hpp"
#include "conceptplan/planners/search_guard.hpp"
#include "legality_trace.hpp"
#include "option_range.hpp"
#include "sparse_belief.hpp"

namespace conceptplan {
namespace {

/// States around the start whose rejections are told of when there is no plan.
constexpr std::size_t kTracedStates = 64;
/// Scores that differ by less are equal, and length decides.
constexpr double kScoreResolution = 1e-12;

/// The belief that is certain of one state.
SparseBelief only(StateId state) { return {{state, 1}}; }

bool isLessProbable(const Mass& a, const Mass& b) { return a.mass < b.mass; }

SparseBelief withoutImprobable(SparseBelief belief, double least) {
  if (belief.empty()) return belief;
  const double most = std::max_element(belief.begin(), belief.end(), isLessProbable)->mass;
  std::erase_if(belief, [&](const Mass& entry) { return entry.mass < least * most; });
  return belief;
}

/// The first state if the belief is of nothing.
StateId mostProbableState(const SparseBelief& belief) {
  if (belief.empty()) return StateId{0};
  return std::max_element(belief.begin(), belief.end(), isLessProbable)->state;
}

void addNew(std::vector<ScoredSequence>& sequences, const std::vector<ScoredSequence>& more,
            std::size_t most) {
  for (const ScoredSequence& sequence : more) {
    if (sequences.size() >= most) return;
    const bool known =
        std::any_of(sequences.begin(), sequences.end(),
                    [&](const ScoredSequence& other) { return other.actions == sequence.actions; });
    if (!known) sequences.push_back(sequence);
  }
}

/// One problem as the planner sees it.
struct BeliefTask {
  const SymbolGraph& graph;
  SparseBelief start;
  SparseBelief goal;
  double threshold;
};

/// The most probable state before the first action and after each one.
std::vector<StateId> likelyStates(const BeliefTask& task, const ActionSequence& actions) {
  SparseBelief belief = task.start;
  std::vector<StateId> states{mostProbableState(belief)};
  for (const Action action : actions) {
    belief = propagateLegal(task.graph, belief, action, task.threshold);
    keepValid(task.graph, belief);
    states.push_back(mostProbableState(belief));
  }
  return states;
}

Plan judged(const BeliefTask& task, const ActionSequence& actions, Ranking ranking,
            double discount) {
  const PlanProbability probability =
      probabilityOf(task.graph, actions, task.start, task.goal, task.threshold);
  Plan plan;
  plan.actions = actions;
  plan.probability = ranking == Ranking::kJoint ? probability.joint : probability.conditional;
  plan.cost =
      -std::log(plan.probability) - static_cast<double>(actions.size()) * std::log(discount);
  const std::vector<StateId> states = likelyStates(task, actions);
  for (std::size_t step = 1; step < states.size(); ++step) {
    plan.predicted.push_back(task.graph.symbols(states[step]));
  }
  return plan;
}

bool ranksBefore(const Plan& a, const Plan& b) {
  if (std::abs(a.cost - b.cost) > kScoreResolution) return a.cost < b.cost;
  if (a.actions.size() != b.actions.size()) return a.actions.size() < b.actions.size();
  return a.actions < b.actions;
}

/// The action sequences to judge exactly and rank.
struct Candidates {
  std::vector<ScoredSequence> sequences;
  bool left_out = false;   ///< as in BestSequences
  bool all_starts = true;  ///< whether no start state was too improbable to guide the search
};

/// The best sequences to different outcomes, if they are asked for, then the best ones.
Candidates candidates(const BeliefTask& task, const PlanQuery& query,
                      const BeliefPlannerOptions& options, SearchGuard& guard,
                      SearchStatistics& statistics) {
  const SparseBelief start = withoutImprobable(task.start, options.min_hypothesis);
  BeliefSearchOptions search;
  search.legality_threshold = options.legality_threshold;
  search.discount = 1 - options.step_discount;
  search.horizon = query.limits.horizon;
  search.top = query.top;
  search.ranking = options.ranking;
  search.paths_per_belief = query.top;
  const auto values = beliefValues(task.graph, task.goal, search, guard);
  if (!values) return {};
  const BestSequences paths =
      bestSequences(task.graph, start, task.goal, *values, search, guard, statistics);
  Candidates found{paths.sequences, paths.left_out, start.size() == task.start.size()};
  if (options.alternatives == Alternatives::kPaths || guard.stopped()) return found;

  search.paths_per_belief = 1;
  search.distinct_outcomes = true;
  search.least_share = options.alternative_share;
  const BestSequences outcomes =
      bestSequences(task.graph, start, task.goal, *values, search, guard, statistics);
  found.sequences.clear();
  // Outcomes found before a limit struck need not hold the best sequence.
  if (guard.stopped()) addNew(found.sequences, paths.sequences, 1);
  addNew(found.sequences, outcomes.sequences, query.top);
  addNew(found.sequences, paths.sequences, query.top);
  return found;
}

/// Stops the guard if sequences that were left out may be plans, though none was found.
/// @param goal_in_reach whether any sequence to the goal is a plan, however improbable
void giveUpIfLeftOut(const Candidates& found, bool goal_in_reach,
                     const BeliefPlannerOptions& options, std::size_t horizon, SearchGuard& guard) {
  // Of what scores less than kLeastScore, which the discount lowers the more the longer it is.
  const double most_probable =
      kLeastScore / std::pow(1 - options.step_discount, static_cast<double>(horizon));
  if (found.left_out && (goal_in_reach || most_probable > options.min_probability)) {
    guard.stop(PlanStatus::kLimit,
               "no plan was found, but sequences of actions were left out whose discounted "
               "probability is below 1e-12");
  } else if (!found.all_starts && goal_in_reach) {
    guard.stop(PlanStatus::kLimit,
               "no plan was found, but start states were left out whose share is below "
               "min_hypothesis, and the goal is in reach");
  }
}

PlanResult answer(const SymbolGraph& graph, const PlanQuery& query,
                  const BeliefPlannerOptions& options, SearchGuard& guard) {
  const bool hard = options.hard_symbols;
  const BeliefTask task{
      graph,
      hard ? only(graph.mostProbableStart()) : sparseStartBelief(graph, graph.initialBelief()),
      hard ? only(graph.mostProbableGoal()) : sparseStateBelief(graph, graph.problem().goal),
      options.legality_threshold};
  const double discount = 1 - options.step_discount;
  const std::string mismatch = frozenMismatch(graph);
  const double frozen = hard && !mismatch.empty() ? 0 : graph.frozenAgreement();

  // With hard symbols the other objects are taken as most probably read too.
  const std::size_t readings = hard ? 1 : graph.numReadings();
  const std::size_t horizon = query.limits.horizon;

  PlanResult result;
  bool goal_in_reach = false;
  for (std::size_t i = 0; mismatch.empty() && !goal_in_reach && i < readings; ++i) {
    goal_in_reach =
        isInReach(graph, graph.inReading(graph.mostProbableStart(), i),
                  graph.inReading(graph.mostProbableGoal(), i), task.threshold, horizon, guard);
  }
  Candidates found;
  if (frozen > 0) found = candidates(task, query, options, guard, result.statistics);
  for (const ScoredSequence& sequence : found.sequences) {
    Plan plan = judged(task, sequence.actions, options.ranking, discount);
    if (plan.probability > 0) result.plans.push_back(std::move(plan));
  }
  std::sort(result.plans.begin(), result.plans.end(), ranksBefore);

  const double best = result.plans.empty() ? 0 : result.plans.front().probability;
  const bool is_proved = goal_in_reach && !guard.stopped();
  if (best > 0 && (is_proved || best >= options.min_probability)) {
    result.status = PlanStatus::kSolved;
    if (guard.stopped()) result.reason = guard.reason() + "; the best plans found so far";
    if (!goal_in_reach) {
      result.reason = (mismatch.empty() ? outOfReach(horizon) : mismatch) +
                      "; planned for a less probable reading of the pictures";
    }
    result.rejections =
        traceRejections(graph, likelyStates(task, result.plans.front().actions), task.threshold);
    return result;
  }
  result.plans.clear();
  if (!guard.stopped()) {
    giveUpIfLeftOut(found, goal_in_reach, options, horizon, guard);
    for (std::size_t i = 0; mismatch.empty() && !guard.stopped() && i < readings; ++i) {
      giveUpIfUnchecked(graph, graph.inReading(graph.mostProbableStart(), i),
                        graph.inReading(graph.mostProbableGoal(), i), task.threshold, horizon,
                        guard);
    }
  }
  result.status = guard.stopped().value_or(PlanStatus::kInfeasible);
  if (guard.stopped()) {
    result.reason = guard.reason();
  } else {
    explainInfeasible(graph, query, task.threshold, guard, result);
    if (mismatch.empty() && query.count_rejections) {
      // The proof looked at all that the start leads to.
      for (const StateId state : reachableStates(graph, graph.mostProbableStart(), task.threshold,
                                                 horizon, graph.numStates(), &guard)) {
        guard.note(state);
      }
    }
  }
  result.rejections = traceRejections(
      graph,
      reachableStates(graph, graph.mostProbableStart(), task.threshold, horizon, kTracedStates),
      task.threshold);
  return result;
}

}  // namespace

BeliefPlanner::BeliefPlanner(const BeliefPlannerOptions& options) : options_(options) {
  checkOptionRange("legality_threshold", options.legality_threshold, 0, 1);
  checkOptionRange("step_discount", options.step_discount, 0, 0.5);
  checkOptionRange("min_probability", options.min_probability, 0, 1);
  checkOptionRange("min_hypothesis", options.min_hypothesis, 0, 1);
  checkOptionRange("alternative_share", options.alternative_share, 0, 1);
}

PlanResult BeliefPlanner::search(const SymbolGraph& graph, const PlanQuery& query) const {
  return withTally(graph, query, options_.legality_threshold,
                   [&](SearchGuard& guard) { return answer(graph, query, options_, guard); });
}

}  // namespace conceptplan
