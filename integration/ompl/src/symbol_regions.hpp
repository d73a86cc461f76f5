#pragma once

#include <ompl/control/planners/syclop/Decomposition.h>

#include <memory>
#include <vector>

#include "conceptplan/ompl/symbol_state_space.hpp"

namespace conceptplan {

/// The regions through which Syclop leads its search: states that agree in the concepts with the
/// most symbols, as many of these as make no more than 400 regions, and at least one. Regions are
/// neighbours where an action most probably leads from one to the other.
class SymbolRegions final : public ompl::control::Decomposition {
 public:
  explicit SymbolRegions(std::shared_ptr<const SymbolStateSpace> states);

  int getNumRegions() const override { return static_cast<int>(neighbours_.size()); }
  double getRegionVolume(int region) override;
  int locateRegion(const ompl::base::State* state) const override;
  void project(const ompl::base::State* state, std::vector<double>& coordinates) const override;
  void getNeighbors(int region, std::vector<int>& neighbours) const override;
  void sampleFromRegion(int region, ompl::RNG& random,
                        std::vector<double>& coordinates) const override;
  void sampleFullState(const ompl::base::StateSamplerPtr& sampler,
                       const std::vector<double>& coordinates,
                       ompl::base::State* state) const override;

 private:
  int regionOf(StateId state) const;

  std::shared_ptr<const SymbolStateSpace> states_;
  std::vector<Concept> axes_;
  std::vector<std::vector<int>> neighbours_;
};

}  // namespace conceptplan
