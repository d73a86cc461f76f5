#include "rendering/object_models.hpp"

#include <gtest/gtest.h>

#include <string>

namespace conceptplan::rendering {
namespace {

class ObjectModel : public testing::TestWithParam<ObjectType> {};

TEST_P(ObjectModel, StandsOnTheTableWithinItsCell) {
  const Mesh mesh = objectModel(GetParam());
  ASSERT_FALSE(mesh.triangles.empty());
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : mesh.positions) box.extend(p);
  EXPECT_LE(box.max().head<2>().maxCoeff(), 0.0851F);
  EXPECT_GE(box.min().head<2>().minCoeff(), -0.0851F);
  EXPECT_GE(box.min().z(), -0.001F);
  EXPECT_LE(box.min().z(), 0.005F);
  EXPECT_LE(box.max().z(), 0.15F);
  EXPECT_GE(box.sizes().head<2>().maxCoeff(), 0.13F) << "uses its cell";
}

TEST_P(ObjectModel, IsAWellFormedMesh) {
  const Mesh mesh = objectModel(GetParam());
  ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
  ASSERT_EQ(mesh.materials.size(), mesh.triangles.size());
  for (const Eigen::Vector3f& p : mesh.positions) ASSERT_TRUE(p.allFinite());
  for (const Eigen::Vector3f& n : mesh.normals) ASSERT_NEAR(n.norm(), 1, 1e-3F);
  for (const Mesh::Triangle& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) ASSERT_LT(corner, mesh.positions.size());
  }
}

TEST_P(ObjectModel, WearsItsColorAndAContrastingFeature) {
  const Mesh mesh = objectModel(GetParam());
  float body = 0;
  float feature = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Eigen::Vector3f u = mesh.positions[b] - mesh.positions[a];
    const Eigen::Vector3f v = mesh.positions[c] - mesh.positions[a];
    (material(mesh.materials[i]).body ? body : feature) += u.cross(v).norm();
  }
  EXPECT_GT(body, 0.2F * feature);
  EXPECT_GT(feature, 0.08F * body);
}

INSTANTIATE_TEST_SUITE_P(Types, ObjectModel,
                         testing::Values(ObjectType::kBread, ObjectType::kCup, ObjectType::kEgg,
                                         ObjectType::kLettuce, ObjectType::kPlate,
                                         ObjectType::kTomato, ObjectType::kPot, ObjectType::kDyer,
                                         ObjectType::kCellphone, ObjectType::kDishSponge,
                                         ObjectType::kSaltshaker, ObjectType::kPotato),
                         [](const auto& parameter) { return std::string(name(parameter.param)); });

TEST(SolidNoise, IsSmoothAndStaysInItsRange) {
  float last = solidNoise({0, 0.3F, 0.7F});
  for (float x = 0; x < 20; x += 0.01F) {
    const float value = solidNoise({x, 0.3F, 0.7F});
    EXPECT_LE(std::abs(value), 1);
    EXPECT_LT(std::abs(value - last), 0.05F);
    last = value;
  }
}

}  // namespace
}  // namespace conceptplan::rendering
