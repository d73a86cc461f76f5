#include "best_path.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>

#include "radix_queue.hpp"

namespace conceptplan {
namespace {

/// A cost and, where costs are equal, a length, as one number.
using Label = std::uint64_t;

constexpr unsigned kLengthBits = 20;
constexpr std::size_t kLongest = (std::size_t{1} << kLengthBits) - 1;
constexpr PathCost kMostCost = (PathCost{1} << (64 - kLengthBits)) - 1;
constexpr Label kUnreached = std::numeric_limits<Label>::max();

Label labelOf(PathCost cost, std::size_t length) {
  return static_cast<Label>(cost) << kLengthBits | length;
}

PathCost costOf(Label label) { return static_cast<PathCost>(label >> kLengthBits); }

std::size_t lengthOf(Label label) { return label & kLongest; }

/// The best way found to each state. States near each other share a page, which is made when the
/// search first comes there.
class Labels {
 public:
  explicit Labels(std::size_t num_states) : pages_(num_states / kPageStates + 1) {}

  Label operator[](StateId state) const {
    const auto& page = pages_[index(state) / kPageStates];
    return page ? page->labels[index(state) % kPageStates] : kUnreached;
  }

  void set(StateId state, Label label, StateId parent) {
    auto& page = pages_[index(state) / kPageStates];
    if (!page) page = std::make_unique<Page>();
    page->labels[index(state) % kPageStates] = label;
    page->parents[index(state) % kPageStates] = static_cast<std::uint32_t>(parent);
  }

  /// False if it was closed before. @pre it has a label
  bool close(StateId state) {
    std::uint32_t& parent = pages_[index(state) / kPageStates]->parents[index(state) % kPageStates];
    if ((parent & kClosed) != 0) return false;
    parent |= kClosed;
    return true;
  }

  StateId parent(StateId state) const {
    const auto& page = pages_[index(state) / kPageStates];
    return static_cast<StateId>(page->parents[index(state) % kPageStates] & ~kClosed);
  }

 private:
  static constexpr std::uint32_t kClosed = std::uint32_t{1} << 31;  // no state has that number
  static constexpr std::size_t kPageStates = 64;

  struct Page {
    Page() { labels.fill(kUnreached); }

    std::array<Label, kPageStates> labels;
    std::array<std::uint32_t, kPageStates> parents;  // of states that have a label
  };

  std::vector<std::unique_ptr<Page>> pages_;
};

StatePath pathTo(StateId goal, const Labels& labels, const SuccessorFunction& successors) {
  StatePath path;
  path.cost = costOf(labels[goal]);
  std::vector<Successor> next;
  StateId state = goal;
  for (std::size_t i = lengthOf(labels[goal]); i > 0; --i) {
    const StateId before = labels.parent(state);
    const PathCost cost = costOf(labels[state]) - costOf(labels[before]);
    successors(before, next);
    const auto step = std::find_if(next.begin(), next.end(), [&](const Successor& successor) {
      return successor.state == state && successor.cost == cost;
    });
    path.actions.push_back(step->action);
    path.states.push_back(state);
    state = before;
  }
  std::reverse(path.actions.begin(), path.actions.end());
  std::reverse(path.states.begin(), path.states.end());
  return path;
}

}  // namespace

std::optional<std::vector<StatePath>> bestPath(std::size_t num_states, StateId start, StateId goal,
                                               const SuccessorFunction& successors,
                                               const PathHeuristic& heuristic, std::size_t horizon,
                                               SearchGuard& guard, SearchStatistics& statistics) {
  const PathCost least = heuristic(start);
  if (least == kOutOfReach) return std::vector<StatePath>();
  if (least > kMostCost) return std::nullopt;
  Labels labels(num_states);
  RadixQueue<StateId> open;
  std::vector<Successor> next;
  labels.set(start, labelOf(0, 0), start);
  open.push(labelOf(least, 0), start);
  while (!open.empty()) {
    const StateId state = open.pop();
    if (!labels.close(state)) continue;
    if (!guard.expand(statistics)) return std::vector<StatePath>();
    if (state == goal) return std::vector{pathTo(goal, labels, successors)};
    const PathCost cost = costOf(labels[state]);
    const std::size_t length = lengthOf(labels[state]) + 1;
    if (length > std::min(horizon, kLongest)) return std::nullopt;
    successors(state, next);
    for (const Successor& step : next) {
      if (step.cost > kMostCost - cost) return std::nullopt;
      const Label label = labelOf(cost + step.cost, length);
      if (label >= labels[step.state]) continue;
      const PathCost rest = heuristic(step.state);
      if (rest == kOutOfReach) continue;
      if (rest > kMostCost - cost - step.cost) return std::nullopt;
      ++statistics.generated;
      labels.set(step.state, label, state);
      open.push(labelOf(cost + step.cost + rest, length), step.state);
    }
  }
  return std::vector<StatePath>();
}

}  // namespace conceptplan
