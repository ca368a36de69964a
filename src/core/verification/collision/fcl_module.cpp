// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/fcl_module.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include <utility>
#include <variant>

namespace lamina {
namespace {

using Owned = std::unique_ptr<fcl::CollisionGeometryd>;

Owned geometryOf(const BoxShape& box) { return std::make_unique<fcl::Boxd>(box.size_mm); }
Owned geometryOf(const CylinderShape& cylinder) {
  return std::make_unique<fcl::Cylinderd>(cylinder.radius_mm, cylinder.length_mm);
}
Owned geometryOf(const ConeShape& cone) {
  return std::make_unique<fcl::Coned>(cone.radius_mm, cone.length_mm);
}
Owned geometryOf(const SphereShape& sphere) { return std::make_unique<fcl::Sphered>(sphere.radius_mm); }

struct FclShape final : CollisionShape {
  explicit FclShape(Owned owned) : geometry(std::move(owned)) {}
  Owned geometry;
};

const fcl::CollisionGeometryd& geometryIn(const CollisionShape& shape) {
  return *static_cast<const FclShape&>(shape).geometry;
}

bool collide(const fcl::CollisionGeometryd& a, const Eigen::Isometry3d& pose_a,
             const fcl::CollisionGeometryd& b, const Eigen::Isometry3d& pose_b) {
  fcl::CollisionResultd result;
  return fcl::collide(&a, pose_a, &b, pose_b, fcl::CollisionRequestd(), result) > 0;
}

std::shared_ptr<const CollisionShape> shapeOf(const BodyShape& shape) {
  return std::make_shared<FclShape>(std::visit([](const auto& solid) { return geometryOf(solid); }, shape));
}

bool meet(const CollisionShape& a, const Eigen::Isometry3d& pose_a, const CollisionShape& b,
          const Eigen::Isometry3d& pose_b) {
  return collide(geometryIn(a), pose_a, geometryIn(b), pose_b);
}

bool meetsBox(const CollisionShape& shape, const Eigen::Isometry3d& pose, const Point3& size,
              const Eigen::Isometry3d& box_pose) {
  return collide(geometryIn(shape), pose, fcl::Boxd(size), box_pose);
}

}  // namespace
}  // namespace lamina

// A name of C.
extern "C" const void* lamina_module();   // NOLINT(readability-identifier-naming)
extern "C" const void* lamina_module() {  // NOLINT(readability-identifier-naming)
  static constexpr lamina::FclModule kTable{&lamina::shapeOf, &lamina::meet, &lamina::meetsBox};
  return &kTable;
}
