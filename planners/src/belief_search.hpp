#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "conceptplan/planners/belief_planner.hpp"
#include "conceptplan/planners/search_guard.hpp"
#include "sparse_belief.hpp"

namespace conceptplan {

/// An action sequence and what it scores: discount^length times its probability.
struct ScoredSequence {
  ActionSequence actions;
  double score = 0;
  StateId outcome{};  ///< most probable final state, in reading 0
};

/// Sequences that score less are no plans.
inline constexpr double kLeastScore = 1e-12;

struct BeliefSearchOptions {
  double legality_threshold = 0;
  double discount = 1;  ///< of one action, in (0, 1]
  std::size_t horizon = 0;
  std::size_t top = 1;               ///< sequences wanted
  std::size_t paths_per_belief = 1;  ///< ways to one belief that are told apart
  bool distinct_outcomes = false;    ///< a sequence counts only if its outcome is new
  Ranking ranking = Ranking::kJoint;
  double least_share = 0;  ///< of the best score; worse sequences are not wanted
};

/// For kJoint the best discounted probability of the goal if the state could be seen after each
/// action; for kConditional the best discounted goal of all states that actions may lead to.
/// [states]; above zero wherever the goal can be reached within the horizon. Nothing if a limit
/// strikes.
std::optional<std::vector<double>> beliefValues(const SymbolGraph& graph, const SparseBelief& goal,
                                                const BeliefSearchOptions& options,
                                                SearchGuard& guard);

struct BestSequences {
  std::vector<ScoredSequence> sequences;  ///< best first
  bool left_out = false;  ///< whether sequences were left out that score less than kLeastScore
};

/// The best action sequences by score, best first, by best-first search over beliefs.
///
/// The search is exact, since it is ordered by an upper bound of the score. For kJoint a belief is
/// never scaled, so its future is linear in it and
/// `score <= discount^t * sum over s of b(s) V(s)`, where V is the value if the state could be seen
/// (Littman, Cassandra and Kaelbling's QMDP, 1995, doi:10.1016/b978-1-55860-377-6.50052-9). For
/// kConditional scaling may leave any one state, so the bound is the best goal that any state of
/// the belief leads to. Sequences that lead to the same belief share its node, since the rest of
/// their score is the same; a path is dropped where `paths_per_belief` others that are no longer
/// were gone on with. Of equally probable sequences the shorter come first, also without a
/// discount. Actions that leave the belief as it is are not taken. Once a limit strikes, the best
/// sequences found so far follow, unproved.
/// @param start a measure over states; what it leaves out is not searched for.
/// @param values `beliefValues` of the same goal and options.
BestSequences bestSequences(const SymbolGraph& graph, const SparseBelief& start,
                            const SparseBelief& goal, const std::vector<double>& values,
                            const BeliefSearchOptions& options, SearchGuard& guard,
                            SearchStatistics& statistics);

}  // namespace conceptplan
