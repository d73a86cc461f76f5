#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <optional>
#include <string_view>

namespace conceptplan {

/// Household object categories: the first eight are seen in training, the last four are not.
enum class ObjectType {
  kBread,
  kCup,
  kEgg,
  kLettuce,
  kPlate,
  kTomato,
  kPot,
  kDyer,
  kCellphone,
  kDishSponge,
  kSaltshaker,
  kPotato
};

inline constexpr std::size_t kNumObjectTypes = 12;
inline constexpr std::size_t kNumSeenTypes = 8;

/// "Bread", "Cup", ... as in the enumerators.
std::string_view name(ObjectType type);
std::optional<ObjectType> objectTypeNamed(std::string_view name);

/// A cell of the workbench: column `x` in [0, columns), row `y` in [0, rows); row 0 is nearest to
/// the camera.
struct Cell {
  int x = 0;
  int y = 0;
  auto operator<=>(const Cell&) const = default;
};

/// The ground truth of one object, as the simulator knows it.
struct ObjectState {
  ObjectType type = ObjectType::kBread;
  Cell cell;
  int rotation = 0;  ///< quarter turns counter-clockwise seen from above, in [0, 4)
  int color = 0;     ///< red, yellow, green, cyan, blue, magenta, in [0, 6)
  int size = 0;      ///< smallest to largest, in [0, 4)
  auto operator<=>(const ObjectState&) const = default;
};

/// "red", "yellow", "green", "cyan", "blue", "magenta". @pre color in [0, 6)
std::string_view colorName(int color);

/// Edge length of an object of the size relative to the largest: 0.55, 0.70, 0.85, 1.
/// @pre size in [0, 4)
double sizeScale(int size);

}  // namespace conceptplan
