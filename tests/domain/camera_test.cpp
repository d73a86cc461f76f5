#include "conceptplan/domain/camera.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "conceptplan/domain/workbench.hpp"

namespace conceptplan {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(LookAt, PutsTheTargetInTheMiddleUprightAtItsDepth) {
  const Vector3d eye(0.3, -2, 1.5);
  const Vector3d target(0.1, 0.4, 0.2);
  const Camera camera = lookAt(eye, target, 0.6);
  EXPECT_TRUE(camera.project(target).isApprox(Vector2d(192, 128), 1e-9));
  EXPECT_NEAR((camera.X_WC.inverse() * target).z(), (target - eye).norm(), 1e-12);
  EXPECT_LT(camera.project(target + Vector3d(0, 0, 0.1)).y(), 128);
  EXPECT_NEAR(camera.X_WC.linear().determinant(), 1, 1e-12);
  EXPECT_NEAR(camera.X_WC.linear().col(0).z(), 0, 1e-12);
}

TEST(LookAt, OpensAsWideAsItSays) {
  const double field = 0.6;
  const Camera camera = lookAt({0, -1, 0}, {0, 0, 0}, field);
  EXPECT_NEAR(camera.project({0, 0, std::tan(field / 2)}).y(), 0, 1e-9);
  EXPECT_NEAR(camera.project({0, 0, -std::tan(field / 2)}).y(), 256, 1e-9);
}

TEST(LookAt, RejectsAVerticalDirectionAndAnImpossibleFieldOfView) {
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  EXPECT_THAT(
      [] {
        lookAt({0, 0, 1}, {0, 0, 0}, 0.5);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("0 -1)")));
  EXPECT_THAT(
      [] {
        lookAt({0, -1, 1}, {0, 0, 0}, 4);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("found 4 rad")));
  EXPECT_THROW(lookAt({0, -1, 1}, {0, 0, 0}, 0), std::invalid_argument);
}

TEST(Camera, UnprojectUndoesProject) {
  const Camera camera = standardCamera();
  const Vector3d p_W(0.23, 0.31, 0.07);
  const double depth = (camera.X_WC.inverse() * p_W).z();
  EXPECT_TRUE(camera.unproject(camera.project(p_W), depth).isApprox(p_W, 1e-12));
}

TEST(StandardCamera, SeesEveryCellWithAMarginAndUsesTheFrame) {
  const Camera camera = standardCamera();
  EXPECT_TRUE(camera.X_WC.translation().isApprox(Vector3d(0, -1.35, 1.5)));
  Eigen::AlignedBox2d seen;
  const Workbench workbench;
  for (int x = 0; x < workbench.columns; ++x) {
    for (int y = 0; y < workbench.rows; ++y) {
      for (int corner = 0; corner < 8; ++corner) {
        Vector3d p_W;
        p_W << workbench.p_WCell({x, y}), (corner & 4) != 0 ? 0.15 : 0.0;
        p_W.x() += (corner & 1) != 0 ? 0.085 : -0.085;
        p_W.y() += (corner & 2) != 0 ? 0.085 : -0.085;
        seen.extend(camera.project(p_W));
      }
    }
  }
  EXPECT_GT(seen.min().y(), 8);
  EXPECT_LT(seen.max().y(), 248);
  EXPECT_GT(seen.sizes().y(), 0.85 * 240);
  EXPECT_GT(seen.min().x(), 8);
  EXPECT_LT(seen.max().x(), 376);
}

}  // namespace
}  // namespace conceptplan
