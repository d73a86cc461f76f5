#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "conceptplan/planners/planner.hpp"

namespace conceptplan {

/// Counts the expansions of one search and tells when it must stop: at the limits of expansions and
/// time, or when it is cancelled. Serves one thread.
class SearchGuard {
 public:
  /// @param expanded [states], becomes true for each state that is expanded; null: none does
  explicit SearchGuard(const SearchLimits& limits, std::vector<bool>* expanded = nullptr);

  /// Counts the expansion of a state. False once a limit has struck; the expansion must not be made
  /// then.
  bool expand(SearchStatistics& statistics, StateId state) {
    if (!expand(statistics)) return false;
    note(state);
    return true;
  }

  /// Notes a state as expanded, where an expansion is not of one state.
  void note(StateId state) {
    if (expanded_ != nullptr) (*expanded_)[index(state)] = true;
  }
  std::vector<bool>* expanded() const { return expanded_; }

  /// Counts one expansion, of whatever.
  bool expand(SearchStatistics& statistics) {
    const bool is_due = statistics.expanded % kClockInterval == 0 || limits_.cancel != nullptr;
    if (is_due || stopped_ || statistics.expanded >= limits_.max_expansions) {
      if (!mayExpand(statistics)) return false;
    }
    ++statistics.expanded;
    return true;
  }

  /// For work that is no expansion, to be asked before each piece of it: false once the time is up
  /// or the search is cancelled, or once it has been stopped.
  bool goesOn() {
    if (asked_++ % kClockInterval == 0 || limits_.cancel != nullptr) return mayGoOn();
    return !stopped_;
  }

  /// Stops the search, as at the limit of expansions, if fewer than so many are left of them. False
  /// once it has been stopped.
  bool leaves(std::size_t expansions, const SearchStatistics& statistics);

  /// For what is told of a search that may have been stopped: false once the time is up or the
  /// search is cancelled.
  bool hasTime() const;

  /// Which limit struck; nothing if none did.
  std::optional<PlanStatus> stopped() const { return stopped_; }

  /// What to tell the user of it; empty if none struck.
  std::string reason() const { return reason_; }

  /// Ends the search for a reason of the planner's own.
  void stop(PlanStatus status, std::string reason);

 private:
  /// The clock is read once in so many expansions or pieces of other work.
  static constexpr std::size_t kClockInterval = 32;

  bool mayGoOn();
  bool mayExpand(const SearchStatistics& statistics);
  bool isCancelled() const;
  bool isLate() const;
  void stopIfLate();
  void stopAtLimit();

  SearchLimits limits_;
  std::vector<bool>* expanded_;
  std::chrono::steady_clock::time_point deadline_;
  std::size_t asked_ = 0;  // for work that is no expansion
  std::optional<PlanStatus> stopped_;
  std::string reason_;
};

}  // namespace conceptplan
