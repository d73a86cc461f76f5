#include "conceptplan/domain/rendering/renderer.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "rendering/color.hpp"
#include "rendering/look.hpp"
#include "rendering/room.hpp"
#include "rendering/scene.hpp"

namespace conceptplan {

using namespace rendering;  // NOLINT: the renderer's own parts
using Eigen::Vector3f;

namespace {

constexpr std::size_t kMaxObjects = 255;

void check(const ObjectState& object) {
  const auto inRange = [](int value, int end) { return value >= 0 && value < end; };
  if (inRange(object.rotation, 4) && inRange(object.color, 6) && inRange(object.size, 4)) return;
  throw std::invalid_argument(
      "Renderer: expected rotation in [0, 4), color in [0, 6) and size in [0, 4), found " +
      std::to_string(object.rotation) + ", " + std::to_string(object.color) + " and " +
      std::to_string(object.size));
}

/// Writes a linear colour as a pixel, with the lens noise of the place.
void write(const Look& look, int x, int y, const Vector3f& color, std::uint8_t* rgb) {
  for (int channel = 0; channel < 3; ++channel) {
    const std::uint8_t code = encode(color[channel]);
    rgb[channel] =
        look.noise.silent()
            ? code
            : static_cast<std::uint8_t>(std::clamp(
                  static_cast<float>(code) + look.noise.at(x, y, channel) + 0.5F, 0.0F, 255.0F));
  }
}

}  // namespace

class Renderer::Implementation {
 public:
  RgbdImage render(const World& world, const Appearance& appearance);
  ObjectCrop renderForeground(const Workbench& workbench, const ObjectState& object,
                              const Appearance& appearance, std::size_t object_index);

 private:
  /// The empty room in one picture, shaded where it has been needed.
  struct Background {
    std::vector<RoomPoint> points;
    std::vector<std::uint8_t> edge;    ///< 1 where surfaces meet
    std::vector<std::uint8_t> shaded;  ///< 1 where `rgb` holds a colour
    std::vector<std::uint8_t> rgb;
  };

  void prepare(const Workbench& workbench, const Appearance& appearance);
  Scene scene(const World& world, std::size_t first_index);
  void traceBackground();
  void showBackground(const std::vector<std::uint8_t>& painted, RgbdImage& image);
  RoomLightMap& lightMap();

  std::optional<Workbench> workbench_;
  std::optional<Room> room_;
  std::optional<Look> look_;
  std::optional<View> view_;
  std::optional<RoomLightMap> light_map_;
  Background background_;
  std::optional<Camera> background_camera_;  ///< whose points the background holds
};

void Renderer::Implementation::prepare(const Workbench& workbench, const Appearance& appearance) {
  if (workbench_ != workbench) {
    room_.emplace(workbench);
    workbench_ = workbench;
    background_camera_.reset();
    background_.shaded.clear();
    light_map_.reset();
  }
  if (!look_ || look_->appearance.seed != appearance.seed ||
      look_->appearance.domain != appearance.domain) {
    look_.emplace(appearance);
    view_.emplace(look_->camera);
    background_.shaded.clear();
    light_map_.reset();
  }
}

RoomLightMap& Renderer::Implementation::lightMap() {
  if (!light_map_) light_map_.emplace(*room_, look_->light);
  return *light_map_;
}

Scene Renderer::Implementation::scene(const World& world, std::size_t first_index) {
  return Scene(
      world, *look_, *view_, *room_, [this]() -> RoomLightMap& { return lightMap(); }, first_index);
}

void Renderer::Implementation::traceBackground() {
  const Camera& camera = look_->camera;
  if (background_camera_ && background_camera_->X_WC.isApprox(camera.X_WC, 0) &&
      background_camera_->focal_px == camera.focal_px) {
    return;
  }
  const int width = view_->width();
  const int height = view_->height();
  background_.points.resize(static_cast<std::size_t>(width * height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; x += kPacket) {
      alignas(32) int valid[kPacket];
      RTCRay8 rays{};
      for (int lane = 0; lane < kPacket; ++lane) {
        valid[lane] = x + lane < width ? -1 : 0;
        view_->setRay(
            rays, static_cast<std::size_t>(lane),
            view_->direction(static_cast<float>(x + lane) + 0.5F, static_cast<float>(y) + 0.5F));
      }
      std::array<RoomPoint, kPacket> points;
      room_->trace(valid, rays, points);
      std::copy_n(points.begin(), std::min(kPacket, width - x),
                  background_.points.begin() + (y * width + x));
    }
  }
  background_.edge.assign(background_.points.size(), 0);
  const auto compare = [&](int a, int b) {
    const RoomPoint& p = background_.points[static_cast<std::size_t>(a)];
    const RoomPoint& q = background_.points[static_cast<std::size_t>(b)];
    if (p.surface == q.surface && p.axis == q.axis) return;
    background_.edge[static_cast<std::size_t>(a)] = 1;
    background_.edge[static_cast<std::size_t>(b)] = 1;
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int i = y * width + x;
      if (x + 1 < width) compare(i, i + 1);
      if (y + 1 < height) compare(i, i + width);
    }
  }
  background_camera_ = camera;
}

/// Fills the pixels that nothing was painted on.
void Renderer::Implementation::showBackground(const std::vector<std::uint8_t>& painted,
                                              RgbdImage& image) {
  background_.shaded.resize(background_.points.size(), 0);
  background_.rgb.resize(3 * background_.points.size());
  const Scene empty = scene(World{*workbench_, {}, 0}, 0);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const auto i = static_cast<std::size_t>(y * image.width + x);
      if (painted[i] != 0) continue;
      if (background_.shaded[i] == 0) {
        const Vector3f color = background_.edge[i] != 0 ? empty.blendedColor(x, y)
                                                        : empty.roomColor(background_.points[i]);
        write(*look_, x, y, color, &background_.rgb[3 * i]);
        background_.shaded[i] = 1;
      }
      std::copy_n(&background_.rgb[3 * i], 3, &image.rgb[3 * i]);
    }
  }
}

RgbdImage Renderer::Implementation::render(const World& world, const Appearance& appearance) {
  if (world.objects.size() > kMaxObjects) {
    throw std::invalid_argument("Renderer: expected at most 255 objects, found " +
                                std::to_string(world.objects.size()));
  }
  std::for_each(world.objects.begin(), world.objects.end(), check);
  prepare(world.workbench, appearance);
  traceBackground();
  const Background& room = background_;
  const Scene objects = scene(world, 0);

  RgbdImage image;
  image.width = view_->width();
  image.height = view_->height();
  image.rgb.resize(3 * room.points.size());
  image.mask.assign(room.points.size(), 0);
  image.depth_m.resize(room.points.size());
  std::transform(room.points.begin(), room.points.end(), image.depth_m.begin(),
                 [](const RoomPoint& point) { return point.depth; });
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * image.width + x); };

  // Each pixel is painted once, whichever objects reach it.
  std::vector<std::uint8_t> painted(room.points.size(), 0);
  const auto paint = [&](int x, int y, const Vector3f& color) {
    painted[at(x, y)] = 1;
    write(*look_, x, y, color, &image.rgb[3 * at(x, y)]);
  };
  for (std::size_t k = 0; k < world.objects.size(); ++k) {
    const PixelBox& box = objects.box(k);
    for (int y = box.top; y < box.bottom; ++y) {
      for (int x = box.left; x < box.right; ++x) {
        if (painted[at(x, y)] != 0) continue;
        const std::uint8_t owner = objects.owner(x, y);
        if (owner != Scene::kNobody) {
          image.mask[at(x, y)] = owner;
          image.depth_m[at(x, y)] = objects.depth(x, y);
        }
        if (objects.atEdge(x, y)) {
          paint(x, y, objects.blendedColor(x, y));
        } else if (owner != Scene::kNobody) {
          paint(x, y, objects.objectColor(x, y));
        }
      }
    }
  }
  for (std::size_t k = 0; k < world.objects.size(); ++k) {
    const PixelBox box = objects.dimmedBox(k);
    for (int y = box.top; y < box.bottom; ++y) {
      for (int x = box.left; x < box.right; ++x) {
        const std::size_t i = at(x, y);
        const RoomPoint& point = room.points[i];
        if (painted[i] != 0 || (point.surface != RoomSurface::kTable && room.edge[i] == 0))
          continue;
        paint(x, y, room.edge[i] != 0 ? objects.blendedColor(x, y) : objects.roomColor(point));
      }
    }
  }
  showBackground(painted, image);
  return image;
}

ObjectCrop Renderer::Implementation::renderForeground(const Workbench& workbench,
                                                      const ObjectState& object,
                                                      const Appearance& appearance,
                                                      std::size_t object_index) {
  check(object);
  prepare(workbench, appearance);
  const Scene alone = scene(World{workbench, {object}, 0}, object_index);
  const PixelBox& box = alone.box(0);
  PixelBox seen{box.right, box.bottom, box.left, box.top};
  for (int y = box.top; y < box.bottom; ++y) {
    for (int x = box.left; x < box.right; ++x) {
      if (alone.owner(x, y) == Scene::kNobody) continue;
      seen = {std::min(seen.left, x), std::min(seen.top, y), std::max(seen.right, x + 1),
              std::max(seen.bottom, y + 1)};
    }
  }
  if (seen.right <= seen.left) {
    throw std::invalid_argument("Renderer: the object at cell (" + std::to_string(object.cell.x) +
                                ", " + std::to_string(object.cell.y) + ") lies outside the frame");
  }
  constexpr int kEdge = ObjectCrop::kEdge;
  ObjectCrop crop;
  crop.rgb.resize(3 * kEdge * kEdge);
  crop.depth_m.resize(kEdge * kEdge);
  crop.mask.resize(kEdge * kEdge);
  crop.left = (seen.left + seen.right) / 2 - kEdge / 2;
  crop.top = (seen.top + seen.bottom) / 2 - kEdge / 2;
  for (int y = std::max(seen.top, crop.top); y < std::min(seen.bottom, crop.top + kEdge); ++y) {
    for (int x = std::max(seen.left, crop.left); x < std::min(seen.right, crop.left + kEdge); ++x) {
      if (alone.owner(x, y) == Scene::kNobody) continue;
      const auto i = static_cast<std::size_t>((y - crop.top) * kEdge + (x - crop.left));
      crop.mask[i] = 1;
      crop.depth_m[i] = alone.depth(x, y);
      write(*look_, x, y, alone.atEdge(x, y) ? alone.blendedColor(x, y) : alone.objectColor(x, y),
            &crop.rgb[3 * i]);
    }
  }
  return crop;
}

Renderer::Renderer() : implementation_(std::make_unique<Implementation>()) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

RgbdImage Renderer::render(const World& world, const Appearance& appearance) {
  return implementation_->render(world, appearance);
}

ObjectCrop Renderer::renderForeground(const Workbench& workbench, const ObjectState& object,
                                      const Appearance& appearance, std::size_t object_index) {
  return implementation_->renderForeground(workbench, object, appearance, object_index);
}

Camera Renderer::camera(const Appearance& appearance) { return Look(appearance).camera; }

}  // namespace conceptplan
