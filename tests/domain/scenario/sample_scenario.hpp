#pragma once

#include "conceptplan/domain/scenario/reference.hpp"
#include "conceptplan/domain/scenario/scenario.hpp"

namespace conceptplan {

/// A frame of 384 x 256 in which instances 1 to `objects` are squares.
inline RgbdImage sampleFrame(int objects) {
  RgbdImage image{kFrameWidth, kFrameHeight, {}, {}, {}};
  const std::size_t pixels = static_cast<std::size_t>(kFrameWidth) * kFrameHeight;
  image.rgb.assign(3 * pixels, 90);
  image.depth_m.assign(pixels, 1.5f);
  image.mask.assign(pixels, 0);
  for (int object = 0; object < objects; ++object) {
    for (int y = 100; y < 120; ++y) {
      for (int x = 40 * object; x < 40 * object + 20; ++x) {
        image.mask[static_cast<std::size_t>(y * kFrameWidth + x)] =
            static_cast<std::uint8_t>(object + 1);
      }
    }
  }
  return image;
}

inline Scenario pictureScenario(int objects) {
  Scenario scenario;
  scenario.name = "sample";
  scenario.input = PictureInput{sampleFrame(objects), sampleFrame(objects)};
  scenario.target = 1;
  return scenario;
}

inline Reference sampleReference() {
  Reference reference;
  Task& task = reference.task;
  task.id = "level3-000007";
  task.level = 3;
  task.initial.objects = {{ObjectType::kCup, {0, 2}, 1, 0, 2},
                          {ObjectType::kPot, {2, 4}, 3, 5, 0},
                          {ObjectType::kDyer, {1, 1}, 0, 3, 3}};
  task.initial.target = 1;
  task.goal = {ObjectType::kPot, {2, 1}, 3, 3, 0};
  task.reference = {Action::kMoveBack, Action::kMoveBack, Action::kMoveBack, Action::kChangeColor};
  task.appearance = 18446744073709551615u;
  reference.domain = RenderDomain::kShifted;
  return reference;
}

}  // namespace conceptplan
