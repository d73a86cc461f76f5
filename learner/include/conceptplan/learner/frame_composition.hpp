#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/learner/concept_learner.hpp"

namespace conceptplan {

/// What may stand before a drawn object: [height, width], millimetres along the camera's axis of
/// all objects of a picture, 0 elsewhere.
std::vector<std::uint16_t> objectsDepth_mm(const RgbdImage& image);

/// The object with no opacity where another object stands nearer to the camera.
/// others_mm [height, width] as of `objectsDepth_mm`.
DrawnObject hiddenBehind(DrawnObject object, std::span<const std::uint16_t> others_mm, int width);

/// Sets mask and depth of a picture where the object was drawn; colours are not touched.
/// `object` is as of `hiddenBehind`. @pre the picture has depth and mask of its size
void placeInstance(RgbdImage& image, std::uint8_t instance, const DrawnObject& object);

}  // namespace conceptplan
