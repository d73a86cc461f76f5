#include "conceptplan/domain/action.hpp"

namespace conceptplan {
namespace {

constexpr std::array<std::string_view, kNumActions> kNames{
    "move_front",  "move_back",    "move_left",   "move_right",
    "rotate_left", "rotate_right", "change_color"};

}  // namespace

std::string_view name(Action action) { return kNames.at(index(action)); }

std::vector<std::string_view> actionNames() { return {kNames.begin(), kNames.end()}; }

std::optional<Action> actionNamed(std::string_view name) {
  for (const Action candidate : kActions)
    if (kNames[index(candidate)] == name) return candidate;
  return std::nullopt;
}

}  // namespace conceptplan
