#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace conceptplan {

/// The seven atomic actions on the target object. Front is +y, away from the camera; right is +x;
/// left turns are counter-clockwise seen from above. Source: Sec. II-B of arXiv 2310.03325.
enum class Action {
  kMoveFront,
  kMoveBack,
  kMoveLeft,
  kMoveRight,
  kRotateLeft,
  kRotateRight,
  kChangeColor
};

inline constexpr std::size_t kNumActions = 7;

inline constexpr std::array<Action, kNumActions> kActions{
    Action::kMoveFront,  Action::kMoveBack,    Action::kMoveLeft,   Action::kMoveRight,
    Action::kRotateLeft, Action::kRotateRight, Action::kChangeColor};

using ActionSequence = std::vector<Action>;

constexpr std::size_t index(Action action) { return static_cast<std::size_t>(action); }

/// "move_front", "move_back", "move_left", "move_right", "rotate_left", "rotate_right" or
/// "change_color".
std::string_view name(Action action);

/// Of all actions, in the order of `kActions`.
std::vector<std::string_view> actionNames();

/// The action of that name; nothing if there is none.
std::optional<Action> actionNamed(std::string_view name);

}  // namespace conceptplan
