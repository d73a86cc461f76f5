#pragma once

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
  RgbdImage render(const World& world, const Appearance& appearance);

  /// One object alone on the workbench, without room: its crop as `cropObject` of a full frame
  /// would give it.
  ObjectCrop renderForeground(const Workbench& workbench, const ObjectState& object,
                              const Appearance& appearance);

  /// The camera of an appearance: the standard one, or a shifted one.
  static Camera camera(const Appearance& appearance);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace conceptplan
