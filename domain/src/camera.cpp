#include "conceptplan/domain/camera.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "conceptplan/domain/image.hpp"

namespace conceptplan {

Camera lookAt(const Eigen::Vector3d& p_WEye, const Eigen::Vector3d& p_WTarget,
              double vertical_field_of_view_rad) {
  const Eigen::Vector3d forward = p_WTarget - p_WEye;
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ());
  const bool opens = vertical_field_of_view_rad > 0 && vertical_field_of_view_rad < M_PI;
  if (!opens || !(right.norm() > 1e-9)) {
    std::ostringstream message;
    message << "lookAt: expected a field of view in (0, pi) and a direction that is not vertical, "
            << "found " << vertical_field_of_view_rad << " rad and direction ("
            << forward.transpose() << ")";
    throw std::invalid_argument(message.str());
  }
  const Eigen::Vector3d z = forward.normalized();
  const Eigen::Vector3d x = right.normalized();
  Camera camera;
  camera.width = kFrameWidth;
  camera.height = kFrameHeight;
  camera.focal_px = 0.5 * kFrameHeight / std::tan(0.5 * vertical_field_of_view_rad);
  camera.center_px = {0.5 * kFrameWidth, 0.5 * kFrameHeight};
  camera.X_WC.linear() << x, z.cross(x), z;
  camera.X_WC.translation() = p_WEye;
  return camera;
}

Camera standardCamera() {
  constexpr double kVerticalFieldOfView_rad = 27.3 * M_PI / 180;
  return lookAt({0, -1.35, 1.5}, {0, 0.02, 0}, kVerticalFieldOfView_rad);
}

}  // namespace conceptplan
