#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace conceptplan {

/// The six visual concepts of an object, in the order of its tokens.
/// Source: Sec. II-A of arXiv 2310.03325.
enum class Concept { kType, kPositionX, kPositionY, kRotation, kColor, kSize };

inline constexpr std::size_t kNumConcepts = 6;

inline constexpr std::array<Concept, kNumConcepts> kConcepts{
    Concept::kType,     Concept::kPositionX, Concept::kPositionY,
    Concept::kRotation, Concept::kColor,     Concept::kSize};

/// Number of values of each concept in the training set: 8 types, 3 columns, 5 rows,
/// 4 quarter turns, 6 colours, 4 sizes.
inline constexpr std::array<std::size_t, kNumConcepts> kConceptCardinality{8, 3, 5, 4, 6, 4};

constexpr std::size_t index(Concept which) { return static_cast<std::size_t>(which); }

/// "TYPE", "POSITION_X", "POSITION_Y", "ROTATION", "COLOR" or "SIZE".
std::string_view name(Concept which);

/// The concept of that name; nothing if there is none.
std::optional<Concept> conceptNamed(std::string_view name);

}  // namespace conceptplan
