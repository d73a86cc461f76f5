#pragma once

#include <cstddef>
#include <span>

#include "conceptplan/domain/model/symbolic_model.hpp"
#include "conceptplan/learner/tokens.hpp"

namespace conceptplan {

/// The context tokens of the causal transition: for each concept whose effect was learned to depend
/// on the same concept of another object, that object's token; zeros elsewhere.
/// @param others,other_tokens the objects beside the target, in the same order
Tokens effectContext(const SymbolicModel& model, Action action, const Symbols& target,
                     std::span<const Symbols> others, std::span<const Tokens> other_tokens);

}  // namespace conceptplan
