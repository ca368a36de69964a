// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/solid.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

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

BodyShape grownFrom(const BoxShape& box, double margin) {
  return BoxShape{box.size_mm + Point3::Constant(2.0 * margin)};
}
BodyShape grownFrom(const CylinderShape& cylinder, double margin) {
  return CylinderShape{cylinder.radius_mm + margin, cylinder.length_mm + 2.0 * margin};
}
BodyShape grownFrom(const ConeShape& cone, double margin) {
  return CylinderShape{cone.radius_mm + margin, cone.length_mm + 2.0 * margin};
}
BodyShape grownFrom(const SphereShape& sphere, double margin) {
  return SphereShape{sphere.radius_mm + margin};
}

bool collide(const fcl::CollisionGeometryd& a, const Eigen::Isometry3d& pose_a,
             const fcl::CollisionGeometryd& b, const Eigen::Isometry3d& pose_b) {
  fcl::CollisionResultd result;
  return fcl::collide(&a, pose_a, &b, pose_b, fcl::CollisionRequestd(), result) > 0;
}

}  // namespace

BodyShape grown(const BodyShape& shape, double margin) {
  return std::visit([margin](const auto& solid) { return grownFrom(solid, margin); }, shape);
}

struct Solid::Geometry {
  Owned shape;
};

Solid::Solid(const BodyShape& shape)
    : shape_(shape),
      geometry_(std::make_shared<Geometry>(
          Geometry{std::visit([](const auto& solid) { return geometryOf(solid); }, shape)})) {}

Extents Solid::extentsAt(const Eigen::Isometry3d& pose, const Point3& normal) const {
  const auto reach = [&](const Point3& direction) {
    return extent(shape_, pose.linear().transpose() * direction);
  };
  Extents extents;
  for (int i = 0; i < 3; ++i) {
    extents.box.low[i] = pose.translation()[i] - reach(-Point3::Unit(i));
    extents.box.high[i] = pose.translation()[i] + reach(Point3::Unit(i));
  }
  const double along = normal.dot(pose.translation());
  extents.low_normal = along - reach(-normal);
  extents.high_normal = along + reach(normal);
  return extents;
}

bool Solid::meets(const DepositedBox& box, const Eigen::Isometry3d& pose) const {
  const fcl::Boxd material(box.size.cast<double>());
  return collide(*geometry_->shape, pose, material, box.pose());
}

bool Solid::meets(const Solid& other, const Eigen::Isometry3d& other_pose,
                  const Eigen::Isometry3d& pose) const {
  return collide(*geometry_->shape, pose, *other.geometry_->shape, other_pose);
}

}  // namespace lamina
