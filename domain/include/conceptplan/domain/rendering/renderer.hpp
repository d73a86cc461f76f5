#pragma once

#include <cstddef>
#include <memory>

#include "conceptplan/domain/camera.hpp"
#include "conceptplan/domain/image.hpp"
#include "conceptplan/domain/object_crop.hpp"
#include "conceptplan/domain/rendering/appearance.hpp"
#include "conceptplan/domain/world.hpp"

namespace conceptplan {

/// Renders worlds as RGB-D pictures with exact instance masks, by ray casting with Embree.
/// The same input gives the same bytes on any number of threads. One instance serves one thread at
/// a time; make one a thread, geometry is shared between them.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// A frame of 384 x 256: room, workbench and all objects. Instance id i + 1 is objects[i].
  /// @throws std::invalid_argument if there are more than 255 objects, or a rotation, colour or
  /// size is out of its range
  RgbdImage render(const World& world, const Appearance& appearance);

  /// One object alone on the workbench, without room: the crop that `cropObject` gives of the
  /// full frame of a world with this object alone, to the byte.
  /// @param object_index selects the colour sample, as the object's index in a world does
  /// @throws std::invalid_argument as `render`, or if the object lies outside the frame
  ObjectCrop renderForeground(const Workbench& workbench, const ObjectState& object,
                              const Appearance& appearance, std::size_t object_index = 0);

  /// The camera of an appearance: the standard one, or a shifted one.
  static Camera camera(const Appearance& appearance);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace conceptplan
