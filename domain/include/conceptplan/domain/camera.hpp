#pragma once

#include <Eigen/Geometry>

namespace conceptplan {

/// A pinhole camera. Frame C has its origin at the eye, x right, y down and z along the axis.
struct Camera {
  int width = 384;
  int height = 256;
  double focal_px = 0;
  Eigen::Vector2d center_px{0, 0};
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();

  /// Pixel coordinates (continuous; pixel centres at +0.5) of a point in W.
  Eigen::Vector2d project(const Eigen::Vector3d& p_W) const {
    const Eigen::Vector3d p_C = X_WC.inverse() * p_W;
    return center_px + focal_px * p_C.head<2>() / p_C.z();
  }

  /// The point in W seen at a pixel at that depth along the axis, metres.
  Eigen::Vector3d unproject(const Eigen::Vector2d& pixel, double depth_m) const {
    Eigen::Vector3d p_C;
    p_C << (pixel - center_px) / focal_px * depth_m, depth_m;
    return X_WC * p_C;
  }
};

/// A camera at `p_WEye` that looks at `p_WTarget`, image upright, frame 384 x 256.
Camera lookAt(const Eigen::Vector3d& p_WEye, const Eigen::Vector3d& p_WTarget,
              double vertical_field_of_view_rad);

/// The camera of the standard domain: 1.5 m above and 1.35 m before the middle of the workbench.
Camera standardCamera();

}  // namespace conceptplan
