#include "symbol_regions.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace conceptplan {
namespace {

/// Syclop leads along paths of regions, whose search must stay a small part of the work.
constexpr std::size_t kMostRegions = 400;

std::vector<Concept> longestAxes(const SymbolStateSpace& states) {
  std::vector<Concept> axes = states.axes();
  std::stable_sort(axes.begin(), axes.end(), [&](Concept a, Concept b) {
    return states.numSymbols(a) > states.numSymbols(b);
  });
  std::size_t regions = 1, chosen = 0;
  while (chosen < axes.size() &&
         (chosen < 1 || regions * states.numSymbols(axes[chosen]) <= kMostRegions))
    regions *= states.numSymbols(axes[chosen++]);
  axes.resize(chosen);
  return axes;
}

ompl::base::RealVectorBounds boundsOf(const SymbolStateSpace& states) {
  const std::vector<Concept> axes = longestAxes(states);
  ompl::base::RealVectorBounds bounds(static_cast<unsigned int>(axes.size()));
  for (unsigned int i = 0; i < axes.size(); ++i) {
    bounds.setLow(i, -0.5);
    bounds.setHigh(i, static_cast<double>(states.numSymbols(axes[i])) - 0.5);
  }
  return bounds;
}

}  // namespace

SymbolRegions::SymbolRegions(std::shared_ptr<const SymbolStateSpace> states)
    : Decomposition(static_cast<int>(longestAxes(*states).size()), boundsOf(*states)),
      states_(std::move(states)),
      axes_(longestAxes(*states_)) {
  std::size_t regions = 1;
  for (const Concept axis : axes_) regions *= states_->numSymbols(axis);
  std::vector<std::set<int>> joined(regions);
  for (std::size_t i = 0; i < states_->numStates(); ++i) {
    const auto state = static_cast<StateId>(i);
    if (!states_->graph().valid(state)) continue;
    for (const Action action : kActions) {
      const StateId next = states_->next(state, action);
      if (!states_->contains(next) || !states_->graph().valid(next)) continue;
      const int from = regionOf(state);
      const int to = regionOf(next);
      if (from == to) continue;
      joined[static_cast<std::size_t>(from)].insert(to);
      joined[static_cast<std::size_t>(to)].insert(from);
    }
  }
  for (const std::set<int>& regions_beside : joined) {
    neighbours_.emplace_back(regions_beside.begin(), regions_beside.end());
  }
}

int SymbolRegions::regionOf(StateId state) const {
  std::size_t region = 0;
  for (const Concept axis : axes_) {
    region = region * states_->numSymbols(axis) + states_->place(state, axis);
  }
  return static_cast<int>(region);
}

double SymbolRegions::getRegionVolume(int) { return 1; }

int SymbolRegions::locateRegion(const ompl::base::State* state) const {
  return regionOf(SymbolStateSpace::id(state));
}

void SymbolRegions::project(const ompl::base::State* state,
                            std::vector<double>& coordinates) const {
  coordinates.clear();
  for (const Concept axis : axes_) {
    coordinates.push_back(static_cast<double>(states_->place(SymbolStateSpace::id(state), axis)));
  }
}

void SymbolRegions::getNeighbors(int region, std::vector<int>& neighbours) const {
  neighbours = neighbours_[static_cast<std::size_t>(region)];
}

void SymbolRegions::sampleFromRegion(int region, ompl::RNG&,
                                     std::vector<double>& coordinates) const {
  coordinates.assign(axes_.size(), 0);
  auto rest = static_cast<std::size_t>(region);
  for (std::size_t i = axes_.size(); i-- > 0;) {
    const std::size_t count = states_->numSymbols(axes_[i]);
    coordinates[i] = static_cast<double>(rest % count);
    rest /= count;
  }
}

void SymbolRegions::sampleFullState(const ompl::base::StateSamplerPtr& sampler,
                                    const std::vector<double>& coordinates,
                                    ompl::base::State* state) const {
  sampler->sampleUniform(state);
  Symbols symbols = states_->graph().symbols(SymbolStateSpace::id(state));
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    symbols[index(axes_[i])] =
        states_->symbolAt(axes_[i], static_cast<std::size_t>(std::lround(coordinates[i])));
  }
  state->as<SymbolStateSpace::StateType>()->id = states_->graph().state(symbols);
}

}  // namespace conceptplan
