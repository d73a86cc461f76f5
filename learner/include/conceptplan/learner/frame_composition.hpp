#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/learner/concept_learner.hpp"

namespace conceptplan {

/// What may stand before a drawn object: [height, width], millimetres along the camera's axis of
/// all objects but that instance, 0 elsewhere.
std::vector<std::uint16_t> othersDepth_mm(const RgbdImage& image, std::uint8_t instance);

/// The object with no opacity where another object stands nearer to the camera.
/// others_mm [height, width] as of `othersDepth_mm`.
DrawnObject hiddenBehind(DrawnObject object, std::span<const std::uint16_t> others_mm, int width);

/// Mask and depth of a picture in which that instance has gone from its place and stands where the
/// object was drawn; colours are not touched. Where it stood, depth goes on as a plane does:
/// inverse depth is linear along a row, between the background on both sides. `object` is as of
/// `hiddenBehind`. @pre the picture has depth and mask of its size
void moveInstance(RgbdImage& image, std::uint8_t instance, const DrawnObject& object);

}  // namespace conceptplan
