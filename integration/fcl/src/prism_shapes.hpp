#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "fcl_bodies.hpp"

namespace conceptplan {

/// Shapes of prisms that were asked for before, since the same few footprints stand in all scenes
/// of a model. Thread-safe; the shapes are never changed.
class PrismShapes {
 public:
  /// As `shapeOf`.
  std::shared_ptr<const fcl::Convexd> find(const Outline& outline, double height_m, double grown_m);

 private:
  using Key = std::array<double, Outline::kDirections + 2>;
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };

  std::mutex mutex_;
  std::unordered_map<Key, std::shared_ptr<const fcl::Convexd>, Hash> shapes_;
};

}  // namespace conceptplan
