#pragma once

#include <cstddef>

namespace conceptplan::testing {

/// What was allocated since this was made, beyond what was then. Counts what operator new gives in
/// this program, in any library; for one thread.
class CountedMemory {
 public:
  CountedMemory();
  double peak_MB() const;  ///< the most at once
  double held_MB() const;  ///< now

 private:
  std::size_t before_;
};

}  // namespace conceptplan::testing
