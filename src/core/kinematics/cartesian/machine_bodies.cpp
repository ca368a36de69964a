// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/cartesian/machine_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/model/body_shape.hpp"
#include "kinematics/model/link_motion.hpp"

namespace lamina {
namespace {

constexpr double kStill = 1e-9;  // mm per mm: rounding of rotations

double extentOf(const BoxShape& box, const Point3& direction) {
  return 0.5 * box.size_mm.dot(direction.cwiseAbs());
}

double extentOf(const CylinderShape& cylinder, const Point3& direction) {
  return cylinder.radius_mm * direction.head<2>().norm() + 0.5 * cylinder.length_mm * std::abs(direction.z());
}

double extentOf(const ConeShape& cone, const Point3& direction) {
  const double apex = 0.5 * cone.length_mm * direction.z();
  return std::max(apex, cone.radius_mm * direction.head<2>().norm() - apex);
}

double extentOf(const SphereShape& sphere, const Point3&) { return sphere.radius_mm; }

double extentOf(const MeshShape& shape, const Point3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Point3& point : *shape.hull) most = std::max(most, direction.dot(point));
  return most + shape.margin_mm;
}

}  // namespace

double extent(const BodyShape& shape, const Point3& direction) {
  return std::visit([&](const auto& solid) { return extentOf(solid, direction); }, shape);
}

double boundingRadius(const BodyShape& shape) {
  Point3 corner;
  for (int i = 0; i < 3; ++i)
    corner[i] = std::max(extent(shape, Point3::Unit(i)), extent(shape, -Point3::Unit(i)));
  return corner.norm();
}

std::vector<MachineBody> movingBodies(const CartesianMachine& machine) {
  const auto model = parseMachine(machine.urdf);
  const LinkMotion bed = motionOf(*model, "bed");
  const Eigen::Isometry3d bed_from_root = bed.root_from_link.inverse();
  std::vector<MachineBody> bodies;
  for (const auto& [name, link] : model->links_) {
    if (link->collision_array.empty()) continue;
    const LinkMotion motion = motionOf(*model, name);
    const Eigen::Matrix3d over_bed = bed_from_root.linear() * (motion.axes - bed.axes);
    if (over_bed.cwiseAbs().maxCoeff() < kStill) continue;
    for (const auto& collision : link->collision_array)
      bodies.push_back({name, shapeOf(*collision, name),
                        bed_from_root * motion.root_from_link * poseOf(collision->origin), over_bed});
  }
  return bodies;
}

}  // namespace lamina
