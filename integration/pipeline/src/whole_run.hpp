#pragma once

#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace conceptplan::training {

/// A part of a stage's work.
struct Work {
  std::string_view name;  ///< under which it reports
  double percent;         ///< of the time of a whole training with the profile `cpu`, typically
};

/// How far a run of several stages is, in percents of a whole training.
class WholeRun {
 public:
  WholeRun() = default;
  /// @param works in the order in which they are done; some may turn out to be done already
  explicit WholeRun(std::vector<Work> works) : works_(std::move(works)) {}

  /// `share` of the work of that name is done; works before it are. Other names change nothing.
  void reach(std::string_view name, double share) {
    std::size_t at = current_;
    while (at < works_.size() && works_[at].name != name) ++at;
    if (at == works_.size()) return;
    if (at != current_ || !begun_) {  // what an earlier run did is no work of this one
      if (begun_) worked_ += works_[current_].percent * (1 - share_);
      current_ = at;
      begun_ = true;
    } else {
      worked_ += works_[at].percent * (share - share_);
    }
    share_ = share;
  }

  /// What was done since the first call of `reach`.
  double worked() const { return worked_; }

  double left() const {
    double left = 0;
    for (std::size_t i = current_; i < works_.size(); ++i)
      left += works_[i].percent * (i == current_ ? 1 - share_ : 1);
    return left;
  }

 private:
  std::vector<Work> works_;
  std::size_t current_ = 0;
  bool begun_ = false;
  double share_ = 0;
  double worked_ = 0;
};

}  // namespace conceptplan::training
