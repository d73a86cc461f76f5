#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

#include "joint_target.hpp"
#include "path_rank.hpp"

namespace conceptplan {

/// The states of all targets, packed to one number.
using JointState = std::uint64_t;

/// One way out of a joint state.
struct JointSuccessor {
  std::size_t target = 0;  ///< index into the problem's targets
  TargetStep step;
  JointState state = 0;
};

/// How far a state is from the goal; less is nearer.
struct JointNearness {
  std::size_t out_of_reach = 0;  ///< targets of which no steps lead to the goal, whatever is away
  PathRank rank = 0;             ///< least, of the others, each by itself with nothing in its way
  std::size_t different = 0;     ///< symbols

  auto operator<=>(const JointNearness&) const = default;
};

}  // namespace conceptplan
