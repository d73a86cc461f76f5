#include "conceptplan/ompl/action_space.hpp"

#include <ostream>
#include <random>

namespace conceptplan {
namespace {

using ompl::base::State;
using ompl::control::Control;

constexpr int kNoAction = static_cast<int>(kNumActions);

int& valueOf(Control* control) { return control->as<ActionSpace::ControlType>()->value; }

class ActionSampler final : public ompl::control::ControlSampler {
 public:
  explicit ActionSampler(const ompl::control::ControlSpace* space)
      : ControlSampler(space), states_(space->getStateSpace()->as<SymbolStateSpace>()) {}

  ActionSampler(const ompl::control::ControlSpace* space, std::uint64_t seed)
      : ActionSampler(space) {
    rng_.setLocalSeed(static_cast<std::uint32_t>(seed));
  }

  void sample(Control* control) override { valueOf(control) = draw(kNumActions); }

  void sample(Control* control, const State* state) override {
    const StateId from = SymbolStateSpace::id(state);
    std::array<Action, kNumActions> moving{};
    std::size_t count = 0;
    for (const Action action : kActions) {
      const StateId to = states_->next(from, action);
      if (to != from && states_->contains(to) && states_->graph().valid(to)) {
        moving[count++] = action;
      }
    }
    if (count == 0) return sample(control);
    valueOf(control) = static_cast<int>(moving[static_cast<std::size_t>(draw(count))]);
  }

  void sampleNext(Control* control, const Control*) override { sample(control); }

  void sampleNext(Control* control, const Control*, const State* state) override {
    sample(control, state);
  }

 private:
  int draw(std::size_t count) { return rng_.uniformInt(0, static_cast<int>(count) - 1); }

  const SymbolStateSpace* states_;
};

}  // namespace

ActionSpace::ActionSpace(const std::shared_ptr<SymbolStateSpace>& states)
    : DiscreteControlSpace(states, 0, kNoAction - 1) {
  setName("ActionSpace");
}

std::optional<Action> ActionSpace::action(const Control* control) {
  const int value = control->as<ControlType>()->value;
  if (value < 0 || value >= kNoAction) return std::nullopt;
  return static_cast<Action>(value);
}

void ActionSpace::seedSamplers(std::uint64_t seed) {
  setControlSamplerAllocator(
      [random = std::mt19937_64(seed)](const ompl::control::ControlSpace* space) mutable {
        return std::make_shared<ActionSampler>(space, random());
      });
}

ompl::control::ControlSamplerPtr ActionSpace::allocDefaultControlSampler() const {
  return std::make_shared<ActionSampler>(this);
}

void ActionSpace::nullControl(Control* control) const { valueOf(control) = kNoAction; }

void ActionSpace::printControl(const Control* control, std::ostream& out) const {
  const std::optional<Action> which = action(control);
  out << (which ? name(*which) : "no action") << '\n';
}

}  // namespace conceptplan
