#pragma once

#include <ompl/control/spaces/DiscreteControlSpace.h>

#include <memory>
#include <optional>

#include "conceptplan/ompl/symbol_state_space.hpp"

namespace conceptplan {

/// The actions as a control space of OMPL. Its samplers draw from the actions that lead from the
/// given state to another valid one; from all where there are none, or where no state is given.
class ActionSpace final : public ompl::control::DiscreteControlSpace {
 public:
  explicit ActionSpace(const std::shared_ptr<SymbolStateSpace>& states);

  /// The action of a control; nothing for the null control.
  static std::optional<Action> action(const ompl::control::Control* control);

  /// Samplers made from now on draw from this seed, not from OMPL's generator of the process.
  void seedSamplers(std::uint64_t seed);

  ompl::control::ControlSamplerPtr allocDefaultControlSampler() const override;
  void nullControl(ompl::control::Control* control) const override;
  void printControl(const ompl::control::Control* control, std::ostream& out) const override;
};

}  // namespace conceptplan
