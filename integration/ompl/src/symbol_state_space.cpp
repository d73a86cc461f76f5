#include "conceptplan/ompl/symbol_state_space.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>

#include "graph_tables.hpp"
#include "successors.hpp"

namespace conceptplan {
namespace {

using ompl::base::State;

StateId& idOf(State* state) { return state->as<SymbolStateSpace::StateType>()->id; }

class SymbolStateSampler final : public ompl::base::StateSampler {
 public:
  explicit SymbolStateSampler(const SymbolStateSpace* space)
      : StateSampler(space), states_(space) {}

  SymbolStateSampler(const SymbolStateSpace* space, std::uint64_t seed)
      : SymbolStateSampler(space) {
    rng_.setLocalSeed(static_cast<std::uint32_t>(seed));
  }

  void sampleUniform(State* state) override {
    const int last = static_cast<int>(states_->numStates()) - 1;
    idOf(state) = static_cast<StateId>(rng_.uniformInt(0, last));
  }

  /// Concept after concept, in random order, takes a symbol within what is left of the distance:
  /// all states within it can come, not all with the same probability.
  void sampleUniformNear(State* state, const State* near, double distance) override {
    const SymbolGraph& graph = states_->graph();
    Symbols symbols = graph.symbols(SymbolStateSpace::id(near));
    std::vector<Concept> axes = states_->axes();
    rng_.shuffle(axes.begin(), axes.end());
    for (const Concept axis : axes) {
      std::vector<SymbolId> within;
      for (std::size_t i = 0; i < states_->numSymbols(axis); ++i) {
        const auto symbol = static_cast<SymbolId>(i);
        if (states_->steps(axis, symbols[index(axis)], symbol) <= distance)
          within.push_back(symbol);
      }
      const SymbolId drawn =
          within[static_cast<std::size_t>(rng_.uniformInt(0, static_cast<int>(within.size()) - 1))];
      distance -= states_->steps(axis, symbols[index(axis)], drawn);
      symbols[index(axis)] = drawn;
    }
    idOf(state) = graph.state(symbols);
  }

  void sampleGaussian(State* state, const State* mean, double deviation) override {
    sampleUniformNear(state, mean, std::abs(rng_.gaussian(0, deviation)));
  }

 private:
  const SymbolStateSpace* states_;
};

/// Coordinates of a state: the place of its symbol on each axis. Cells of a grid hold one state.
class SymbolProjection final : public ompl::base::ProjectionEvaluator {
 public:
  explicit SymbolProjection(const SymbolStateSpace* space)
      : ProjectionEvaluator(space), states_(space) {
    setCellSizes(std::vector<double>(getDimension(), 1));
    ompl::base::RealVectorBounds bounds(getDimension());
    bounds.setLow(-0.5);
    bounds.setHigh(0.5);
    for (unsigned int i = 0; i < states_->axes().size(); ++i) {
      bounds.setHigh(i, static_cast<double>(states_->numSymbols(states_->axes()[i])) - 0.5);
    }
    setBounds(bounds);
  }

  unsigned int getDimension() const override { return states_->getDimension(); }

  void project(const State* state, Eigen::Ref<Eigen::VectorXd> projection) const override {
    projection.setZero();
    for (std::size_t i = 0; i < states_->axes().size(); ++i) {
      projection[static_cast<Eigen::Index>(i)] =
          static_cast<double>(states_->place(SymbolStateSpace::id(state), states_->axes()[i]));
    }
  }

 private:
  const SymbolStateSpace* states_;
};

}  // namespace

SymbolStateSpace::SymbolStateSpace(std::shared_ptr<const SymbolGraph> graph,
                                   double legality_threshold, MotionCheck check_motion)
    : graph_(std::move(graph)),
      legality_threshold_(legality_threshold),
      check_motion_(std::move(check_motion)) {
  if (!graph_) throw std::invalid_argument("a state space needs a symbol graph");
  if (!(legality_threshold >= 0 && legality_threshold <= 1)) {
    throw std::invalid_argument("legality_threshold is " + std::to_string(legality_threshold) +
                                ", expected a number in [0, 1]");
  }
  type_ = ompl::base::STATE_SPACE_TYPE_COUNT + 1;
  setName("Symbol" + getName());
  for (const Concept which : kConcepts) {
    if (graph_->mutability(which) == Mutability::kChanges) axes_.push_back(which);
  }
  measureSteps();
  for (const Concept axis : axes_) {
    orderSymbols(axis);
    const std::vector<double>& steps = steps_[index(axis)];
    maximum_extent_ += *std::max_element(steps.begin(), steps.end());
  }
  maximum_extent_ = std::max(maximum_extent_, 1.0);
}

/// Fills `steps_` by breadth-first search from each symbol. All states in one context of an action
/// change alike, so one of them tells which symbols follow each other.
void SymbolStateSpace::measureSteps() {
  const SymbolIndex& states = graph_->tables().states;
  std::array<std::vector<std::vector<std::size_t>>, kNumConcepts> next;  // of each symbol
  for (const Concept axis : axes_)
    next[index(axis)].resize(graph_->problem().goal[index(axis)].size());
  const StateSteps steps =
      likelySuccessors(*graph_, legality_threshold_, [](const Outcome&) { return kNat; });
  for (const StateSteps::ContextSteps& all : steps.ofReading(0)) {
    for (std::size_t context = 0; context < all.contexts.size(); ++context) {
      const Symbols from = all.contexts.symbols(context, graph_->tables().fixed);
      const auto state = static_cast<std::int32_t>(states(from));
      for (std::uint32_t i = all.first[context]; i < all.first[context + 1]; ++i) {
        const Symbols to = graph_->symbols(static_cast<StateId>(state + all.steps[i].shift));
        for (const Concept axis : axes_) {
          const std::size_t k = index(axis);
          if (from[k] == to[k]) continue;
          next[k][index(from[k])].push_back(index(to[k]));
          next[k][index(to[k])].push_back(index(from[k]));
        }
      }
    }
  }
  for (const Concept axis : axes_) {
    const std::size_t k = index(axis);
    const std::size_t count = next[k].size();
    steps_[k].assign(count * count, static_cast<double>(count));
    for (std::size_t from = 0; from < count; ++from) {
      double* const distance = &steps_[k][from * count];
      std::vector<std::size_t> open{from};
      distance[from] = 0;
      for (std::size_t i = 0; i < open.size(); ++i) {
        for (const std::size_t to : next[k][open[i]]) {
          if (distance[to] < static_cast<double>(count)) continue;
          distance[to] = distance[open[i]] + 1;
          open.push_back(to);
        }
      }
    }
  }
}

void SymbolStateSpace::orderSymbols(Concept axis) {
  const std::size_t k = index(axis);
  const std::vector<double>& steps = steps_[k];
  const std::size_t n = graph_->problem().goal[k].size();
  const auto farthest = std::max_element(steps.begin(), steps.end()) - steps.begin();
  const std::size_t end = static_cast<std::size_t>(farthest) / n;
  for (std::size_t i = 0; i < n; ++i) order_[k].push_back(static_cast<SymbolId>(i));
  std::stable_sort(order_[k].begin(), order_[k].end(), [&](SymbolId a, SymbolId b) {
    return steps[end * n + index(a)] < steps[end * n + index(b)];
  });
  place_[k].resize(n);
  for (std::size_t i = 0; i < n; ++i) place_[k][index(order_[k][i])] = i;
}

StateId SymbolStateSpace::next(StateId state, Action action) const {
  if (!contains(state) || graph_->legality(state, action) <= legality_threshold_) return kNowhere;
  const StateId to = graph_->transitions(state, action).front().state;
  if (check_motion_ && to != state && graph_->valid(state) && graph_->valid(to) &&
      !check_motion_(graph_->symbols(state), graph_->symbols(to))) {
    return kNowhere;
  }
  return to;
}

std::size_t SymbolStateSpace::place(StateId state, Concept axis) const {
  return place_[index(axis)][index(graph_->symbols(state)[index(axis)])];
}

double SymbolStateSpace::steps(Concept which, SymbolId from, SymbolId to) const {
  return steps_[index(which)][index(from) * numSymbols(which) + index(to)];
}

void SymbolStateSpace::seedSamplers(std::uint64_t seed) {
  setStateSamplerAllocator(
      [this, random = std::mt19937_64(seed)](const ompl::base::StateSpace*) mutable {
        return std::make_shared<SymbolStateSampler>(this, random());
      });
}

unsigned int SymbolStateSpace::getDimension() const {
  return static_cast<unsigned int>(std::max<std::size_t>(axes_.size(), 1));
}

void SymbolStateSpace::enforceBounds(State* state) const {
  if (!contains(idOf(state))) idOf(state) = StateId{0};
}

bool SymbolStateSpace::satisfiesBounds(const State* state) const { return contains(id(state)); }

void SymbolStateSpace::copyState(State* destination, const State* source) const {
  idOf(destination) = id(source);
}

double SymbolStateSpace::distance(const State* first, const State* second) const {
  if (equalStates(first, second)) return 0;
  if (!contains(id(first)) || !contains(id(second))) return maximum_extent_;
  const Symbols from = graph_->symbols(id(first));
  const Symbols to = graph_->symbols(id(second));
  double sum = 0;
  for (const Concept axis : axes_) sum += steps(axis, from[index(axis)], to[index(axis)]);
  return sum;
}

bool SymbolStateSpace::equalStates(const State* first, const State* second) const {
  return id(first) == id(second);
}

void SymbolStateSpace::interpolate(const State* from, const State* to, double t,
                                   State* state) const {
  copyState(state, t < 0.5 ? from : to);
}

void SymbolStateSpace::serialize(void* serialization, const State* state) const {
  const StateId number = id(state);
  std::memcpy(serialization, &number, sizeof number);
}

void SymbolStateSpace::deserialize(State* state, const void* serialization) const {
  std::memcpy(&idOf(state), serialization, sizeof(StateId));
}

ompl::base::StateSamplerPtr SymbolStateSpace::allocDefaultStateSampler() const {
  return std::make_shared<SymbolStateSampler>(this);
}

void SymbolStateSpace::printState(const State* state, std::ostream& out) const {
  out << "state " << static_cast<std::int32_t>(id(state));
  if (satisfiesBounds(state)) {
    const Symbols symbols = graph_->symbols(id(state));
    for (const Concept axis : axes_) out << ' ' << name(axis) << ' ' << index(symbols[index(axis)]);
  }
  out << '\n';
}

void SymbolStateSpace::registerProjections() {
  registerDefaultProjection(std::make_shared<SymbolProjection>(this));
}

}  // namespace conceptplan
