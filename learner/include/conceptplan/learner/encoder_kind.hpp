#pragma once

#include <optional>
#include <string_view>

namespace conceptplan {

/// What the encoder is given.
enum class EncoderKind {
  kObjectCentred,  ///< crop at native resolution, and its location; ours
  kFullFrame       ///< the foreground in the frame, 256 x 256, RGB-D; the paper's
};

/// "object-centred" or "full-frame".
std::string_view name(EncoderKind encoder);
std::optional<EncoderKind> encoderKindNamed(std::string_view name);

}  // namespace conceptplan
