#include "conceptplan/domain/object.hpp"

#include <stdexcept>
#include <string>

namespace conceptplan {
namespace {

constexpr std::array<std::string_view, kNumObjectTypes> kTypeNames{
    "Bread", "Cup",  "Egg",       "Lettuce",    "Plate",      "Tomato",
    "Pot",   "Dyer", "Cellphone", "DishSponge", "Saltshaker", "Potato"};
constexpr std::array<std::string_view, 6> kColorNames{"red",  "yellow", "green",
                                                      "cyan", "blue",   "magenta"};
constexpr std::array<double, 4> kSizeScales{0.55, 0.70, 0.85, 1.0};

template <typename Value, std::size_t kCount>
Value at(const std::array<Value, kCount>& values, int position, const char* what) {
  if (position < 0 || position >= static_cast<int>(kCount))
    throw std::invalid_argument(std::string(what) + " must be in [0, " + std::to_string(kCount) +
                                "), not " + std::to_string(position));
  return values[static_cast<std::size_t>(position)];
}

}  // namespace

std::string_view name(ObjectType type) { return kTypeNames.at(static_cast<std::size_t>(type)); }

std::optional<ObjectType> objectTypeNamed(std::string_view name) {
  for (std::size_t i = 0; i < kNumObjectTypes; ++i)
    if (kTypeNames[i] == name) return static_cast<ObjectType>(i);
  return std::nullopt;
}

std::string_view colorName(int color) { return at(kColorNames, color, "color"); }

double sizeScale(int size) { return at(kSizeScales, size, "size"); }

}  // namespace conceptplan
