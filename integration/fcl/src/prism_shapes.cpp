#include "prism_shapes.hpp"

#include <algorithm>
#include <string_view>

namespace conceptplan {
namespace {

constexpr std::size_t kMostShapes = 4096;  // of some kilobytes each

}  // namespace

std::size_t PrismShapes::Hash::operator()(const Key& key) const {
  return std::hash<std::string_view>()(
      {reinterpret_cast<const char*>(key.data()), sizeof(double) * key.size()});
}

std::shared_ptr<const fcl::Convexd> PrismShapes::find(const Outline& outline, double height_m,
                                                      double grown_m) {
  Key key;
  std::copy(outline.support_m.begin(), outline.support_m.end(), key.begin());
  key[key.size() - 2] = height_m;
  key[key.size() - 1] = grown_m;
  const std::lock_guard lock(mutex_);
  const auto known = shapes_.find(key);
  if (known != shapes_.end()) return known->second;
  if (shapes_.size() == kMostShapes) shapes_.clear();
  return shapes_[key] = shapeOf(outline, height_m, grown_m);
}

}  // namespace conceptplan
