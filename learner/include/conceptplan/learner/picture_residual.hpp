#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "conceptplan/domain/image.hpp"
#include "conceptplan/learner/concept_learner.hpp"
#include "conceptplan/learner/encoder_input.hpp"

namespace conceptplan {

/// By how much the picture of an object differs from what is drawn of its tokens. Objects like none
/// that was learned are read as one that was, and so look unlike it.
struct PictureResidual {
  double silhouette = 0;  ///< pixels that one of the two covers alone, as a share of those seen
  double depth_m = 0;     ///< mean absolute difference where both are, the mean one taken off
  double color = 0;       ///< mean absolute difference of red, green and blue, 0 to 1, there

  /// Whether each is at most that of the limits.
  bool within(const PictureResidual& limits) const;

  bool operator==(const PictureResidual&) const = default;
};

/// Depths that differ by more than 5 cm count as 5 cm. Where no pixel is common to both, the
/// residual is as large as they come.
/// @param hidden pixels of the crop, [64, 64], not 0 where the object may be and yet not be seen;
/// what is drawn there does not count. Empty: none.
/// @throws std::invalid_argument if planes are not 64 x 64 or no pixel is on the object.
PictureResidual pictureResidual(const EncoderInput& seen, const DrawnObject& drawn,
                                std::span<const std::uint8_t> hidden = {});

/// Of each pixel of an object's crop, whether another object is seen there, or it lies outside the
/// frame, [64, 64].
std::vector<std::uint8_t> hiddenPixels(const RgbdImage& image, std::uint8_t instance,
                                       const EncoderInput& seen);

}  // namespace conceptplan
