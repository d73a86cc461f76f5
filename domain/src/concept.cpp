#include "conceptplan/domain/concept.hpp"

namespace conceptplan {
namespace {

constexpr std::array<std::string_view, kNumConcepts> kNames{"TYPE",     "POSITION_X", "POSITION_Y",
                                                            "ROTATION", "COLOR",      "SIZE"};

}  // namespace

std::string_view name(Concept which) { return kNames.at(index(which)); }

std::optional<Concept> conceptNamed(std::string_view name) {
  for (const Concept candidate : kConcepts)
    if (kNames[index(candidate)] == name) return candidate;
  return std::nullopt;
}

}  // namespace conceptplan
