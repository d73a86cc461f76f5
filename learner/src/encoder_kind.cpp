#include "conceptplan/learner/encoder_kind.hpp"

namespace conceptplan {

std::string_view name(EncoderKind encoder) {
  return encoder == EncoderKind::kObjectCentred ? "object-centred" : "full-frame";
}

std::optional<EncoderKind> encoderKindNamed(std::string_view name) {
  for (const auto encoder : {EncoderKind::kObjectCentred, EncoderKind::kFullFrame})
    if (conceptplan::name(encoder) == name) return encoder;
  return std::nullopt;
}

}  // namespace conceptplan
