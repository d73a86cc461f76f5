#include "belief_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <queue>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "graph_tables.hpp"

namespace conceptplan {
namespace {

/// Beliefs that differ by less than about this share are one node.
constexpr double kBeliefResolution = 1e-9;
constexpr double kValueTolerance = 1e-15;
/// An action costs at least this share of the score, so that of equally probable sequences the
/// shorter come first.
constexpr double kLeastStepDiscount = 1e-12;

double discountOf(const BeliefSearchOptions& options) {
  return std::min(options.discount, 1 - kLeastStepDiscount);
}

class BeliefSearch {
 public:
  BeliefSearch(const SymbolGraph& graph, const SparseBelief& goal,
               const std::vector<double>& values, const BeliefSearchOptions& options,
               SearchGuard& guard)
      : graph_(graph),
        goal_(dense(goal, graph.numStates())),
        options_(options),
        discount_(discountOf(options)),
        values_(values),
        guard_(guard),
        dense_(graph.numStates(), 0) {}

  BestSequences run(const SparseBelief& start, SearchStatistics& statistics) {
    for (const Mass& entry : start) touch(entry.state, entry.mass);
    push(kRoot, Action::kMoveFront, 0, intern(takeTouched()));
    std::vector<ScoredSequence> found;
    while (!queue_.empty() && found.size() < options_.top) {
      const Entry entry = queue_.top();
      queue_.pop();
      if (!found.empty() && entry.score < options_.least_share * found.front().score) break;
      if (entry.is_end) {
        accept(entry, found);
        continue;
      }
      const std::size_t belief = nodes_[entry.node].belief;
      if (hasEnoughPaths(belief, entry.length)) continue;
      if (!guard_.expand(statistics)) break;
      expanded_lengths_[belief].push_back(entry.length);
      for (const Mass& part : beliefs_[belief]) guard_.note(part.state);
      expand(entry.node, statistics);
    }
    if (guard_.stopped()) takeBestSoFar(found);
    return {std::move(found), left_out_};
  }

 private:
  static constexpr std::size_t kRoot = static_cast<std::size_t>(-1);

  struct Node {
    std::size_t parent;
    Action action;
    std::size_t length;
    std::size_t belief;
  };

  struct Entry {
    double score;
    bool is_end;  ///< the sequence ends here; else `score` is a bound
    std::size_t length;
    std::size_t node;

    /// Worse entries are less. Among equals ends come first, the short ones before the long ones;
    /// of what goes on the long ones come first, which are nearer to an end; then older ones.
    bool operator<(const Entry& other) const {
      if (score != other.score) return score < other.score;
      if (is_end != other.is_end) return other.is_end;
      if (length != other.length) return (length < other.length) != is_end;
      return node > other.node;
    }
  };

  /// Adds the sequences that were reached but not proved to be next.
  void takeBestSoFar(std::vector<ScoredSequence>& found) {
    for (; !queue_.empty() && found.size() < options_.top; queue_.pop()) {
      if (queue_.top().is_end) accept(queue_.top(), found);
    }
  }

  /// Whether each continuation of a path to the belief has as many rivals as are wanted, which are
  /// no longer than it.
  bool hasEnoughPaths(std::size_t belief, std::size_t length) const {
    const std::vector<std::size_t>& lengths = expanded_lengths_[belief];
    const auto no_longer = std::count_if(lengths.begin(), lengths.end(),
                                         [length](std::size_t other) { return other <= length; });
    return static_cast<std::size_t>(no_longer) >= options_.paths_per_belief;
  }

  void touch(StateId state, double mass) {
    if (dense_[index(state)] == 0) touched_.push_back(state);
    dense_[index(state)] += mass;
  }

  SparseBelief takeTouched() {
    std::sort(touched_.begin(), touched_.end());
    SparseBelief belief;
    belief.reserve(touched_.size());
    for (const StateId state : touched_) {
      belief.push_back({state, dense_[index(state)]});
      dense_[index(state)] = 0;
    }
    touched_.clear();
    if (options_.ranking == Ranking::kConditional) normalize(belief);
    return belief;
  }

  /// The number of the belief, the same for equal ones.
  std::size_t intern(SparseBelief belief) {
    std::string key;
    key.reserve(belief.size() * (sizeof(StateId) + sizeof(long long)));
    for (const Mass& entry : belief) {
      // Equal shares of the logarithm are equal ratios of the mass.
      const long long rounded = std::llround(std::log(entry.mass) / kBeliefResolution);
      key.append(reinterpret_cast<const char*>(&entry.state), sizeof entry.state);
      key.append(reinterpret_cast<const char*>(&rounded), sizeof rounded);
    }
    const auto [known, is_new] = numbers_.try_emplace(std::move(key), beliefs_.size());
    if (is_new) {
      beliefs_.push_back(std::move(belief));
      expanded_lengths_.emplace_back();
    }
    return known->second;
  }

  double weighed(const SparseBelief& belief, const std::vector<double>& weights) const {
    double sum = 0;
    for (const Mass& entry : belief) sum += entry.mass * weights[index(entry.state)];
    return sum;
  }

  double valueBound(const SparseBelief& belief) const {
    if (options_.ranking == Ranking::kJoint) return weighed(belief, values_);
    double most = 0;
    for (const Mass& entry : belief) most = std::max(most, values_[index(entry.state)]);
    return most;
  }

  bool isLeftOut(double score) {
    if (score >= kLeastScore) return false;
    left_out_ = left_out_ || score > 0;
    return true;
  }

  void push(std::size_t parent, Action action, std::size_t length, std::size_t belief) {
    const double bound = std::pow(discount_, length) * valueBound(beliefs_[belief]);
    if (isLeftOut(bound)) return;
    nodes_.push_back({parent, action, length, belief});
    queue_.push({bound, false, length, nodes_.size() - 1});
  }

  void expand(std::size_t number, SearchStatistics& statistics) {
    const Node node = nodes_[number];
    const double score = std::pow(discount_, node.length) * weighed(beliefs_[node.belief], goal_);
    if (!isLeftOut(score)) queue_.push({score, true, node.length, number});
    if (node.length == options_.horizon) return;
    for (const Action action : kActions) {
      for (const Mass& entry : beliefs_[node.belief]) {
        if (!guard_.goesOn()) return;
        const StateActions actions(graph_, entry.state);
        if (actions.legality(action) <= options_.legality_threshold) continue;
        for (const Transition& transition : actions.transitions(action)) {
          if (graph_.valid(transition.state)) {
            touch(transition.state, entry.mass * transition.probability);
          }
        }
      }
      if (touched_.empty()) continue;
      const std::size_t next = intern(takeTouched());
      ++statistics.generated;
      if (next == node.belief || hasEnoughPaths(next, node.length + 1)) continue;
      push(number, action, node.length + 1, next);
    }
  }

  void accept(const Entry& entry, std::vector<ScoredSequence>& found) {
    const SparseBelief& belief = beliefs_[nodes_[entry.node].belief];
    const auto likeliest = std::max_element(
        belief.begin(), belief.end(), [](const Mass& a, const Mass& b) { return a.mass < b.mass; });
    const StateId outcome = graph_.inReading(likeliest->state, 0);
    if (options_.distinct_outcomes && !outcomes_.insert(index(outcome)).second) return;
    ScoredSequence sequence{{}, entry.score, outcome};
    for (std::size_t i = entry.node; nodes_[i].parent != kRoot; i = nodes_[i].parent) {
      sequence.actions.push_back(nodes_[i].action);
    }
    std::reverse(sequence.actions.begin(), sequence.actions.end());
    found.push_back(std::move(sequence));
  }

  const SymbolGraph& graph_;
  StateBelief goal_;
  const BeliefSearchOptions& options_;
  double discount_;
  const std::vector<double>& values_;
  SearchGuard& guard_;
  bool left_out_ = false;
  std::vector<SparseBelief> beliefs_;
  std::vector<std::vector<std::size_t>> expanded_lengths_;  // of the paths to each belief
  std::unordered_map<std::string, std::size_t> numbers_;
  std::vector<Node> nodes_;
  std::priority_queue<Entry> queue_;
  std::unordered_set<std::size_t> outcomes_;
  StateBelief dense_;  // zero between uses
  std::vector<StateId> touched_;
};

}  // namespace

std::optional<std::vector<double>> beliefValues(const SymbolGraph& graph, const SparseBelief& goal,
                                                const BeliefSearchOptions& options,
                                                SearchGuard& guard) {
  const double discount = discountOf(options);
  std::vector<double> values = dense(goal, graph.numStates());
  for (std::size_t sweep = 0; sweep < options.horizon; ++sweep) {
    double change = 0;
    bool reaches_more = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!guard.goesOn()) return std::nullopt;
      const StateActions actions(graph, static_cast<StateId>(i));
      double best = values[i];
      for (const Action action : kActions) {
        if (actions.legality(action) <= options.legality_threshold) continue;
        double sum = 0;
        double most = 0;
        for (const Transition& transition : actions.transitions(action)) {
          if (!graph.valid(transition.state)) continue;
          sum += transition.probability * values[index(transition.state)];
          most = std::max(most, values[index(transition.state)]);
        }
        best = std::max(best, discount * (options.ranking == Ranking::kJoint ? sum : most));
      }
      change = std::max(change, best - values[i]);
      reaches_more = reaches_more || (best > 0 && values[i] == 0);
      values[i] = best;
    }
    if (change < kValueTolerance && !reaches_more) break;
  }
  return values;
}

BestSequences bestSequences(const SymbolGraph& graph, const SparseBelief& start,
                            const SparseBelief& goal, const std::vector<double>& values,
                            const BeliefSearchOptions& options, SearchGuard& guard,
                            SearchStatistics& statistics) {
  return BeliefSearch(graph, goal, values, options, guard).run(start, statistics);
}

}  // namespace conceptplan
