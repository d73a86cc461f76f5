#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "conceptplan/planners/plan_result.hpp"

namespace conceptplan {

/// Adds rejections up by cause and object.
class RejectionCounter {
 public:
  void add(const Rejection& rejection);

  /// By cause, then by object.
  std::vector<RejectionCount> counts() const;

 private:
  std::map<std::pair<Invalidity, std::optional<std::size_t>>, RejectionCount> counts_;
};

}  // namespace conceptplan
