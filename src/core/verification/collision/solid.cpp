// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/solid.hpp"

#include <variant>

#include "base/module.hpp"
#include "verification/collision/fcl_module.hpp"

namespace lamina {
namespace {

constexpr double kTouching = 1e-6;  // mm: what FCL may take for a collision

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

BodyShape grownFrom(MeshShape mesh, double margin) {
  mesh.margin_mm += margin;
  mesh.is_hull = true;
  return mesh;
}

Box3 boundsOf(const BodyShape& shape) {
  Box3 bounds;
  for (int i = 0; i < 3; ++i) {
    bounds.low[i] = -extent(shape, -Point3::Unit(i)) - kTouching;
    bounds.high[i] = extent(shape, Point3::Unit(i)) + kTouching;
  }
  return bounds;
}

const FclModule& fclModule() {
  static const auto* const module = static_cast<const FclModule*>(moduleTable("fcl"));
  return *module;
}

}  // namespace

BodyShape grown(const BodyShape& shape, double margin) {
  return std::visit([margin](const auto& solid) { return grownFrom(solid, margin); }, shape);
}

Solid::Solid(const BodyShape& shape)
    : shape_(shape), bounds_(boundsOf(shape)), geometry_(fclModule().shape(shape)) {}

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

TurnedBox Solid::boxAt(const Eigen::Isometry3d& pose) const {
  return {pose * Point3(0.5 * (bounds_.low + bounds_.high)), pose.linear(),
          0.5 * (bounds_.high - bounds_.low)};
}

bool Solid::meets(const DepositedBox& box, const Eigen::Isometry3d& pose) const {
  return fclModule().meets_box(*geometry_, pose, box.size.cast<double>(), box.pose());
}

double Solid::distanceTo(const Solid& other, const Eigen::Isometry3d& other_pose,
                         const Eigen::Isometry3d& pose) const {
  return fclModule().apart(*geometry_, pose, *other.geometry_, other_pose);
}

bool Solid::meets(const Solid& other, const Eigen::Isometry3d& other_pose,
                  const Eigen::Isometry3d& pose) const {
  return fclModule().meet(*geometry_, pose, *other.geometry_, other_pose);
}

}  // namespace lamina
