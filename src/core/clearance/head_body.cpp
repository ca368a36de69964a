// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clearance/head_body.hpp"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include <variant>

namespace lamina {
namespace {

using Geometry = std::unique_ptr<fcl::CollisionGeometryd>;

Geometry geometryOf(const BoxShape& box) { return std::make_unique<fcl::Boxd>(box.size_mm); }
Geometry geometryOf(const CylinderShape& cylinder) {
  return std::make_unique<fcl::Cylinderd>(cylinder.radius_mm, cylinder.length_mm);
}
Geometry geometryOf(const ConeShape& cone) {
  return std::make_unique<fcl::Coned>(cone.radius_mm, cone.length_mm);
}
Geometry geometryOf(const SphereShape& sphere) { return std::make_unique<fcl::Sphered>(sphere.radius_mm); }

}  // namespace

struct HeadBody::Solid {
  Geometry geometry;
};

HeadBody::HeadBody(const MachineBody& body, const Machine& machine, const Point3& normal)
    : link_(body.link),
      rotation_(body.bed_from_body_at_zero.linear()),
      normal_(normal),
      solid_(std::make_shared<Solid>(
          Solid{std::visit([](const auto& shape) { return geometryOf(shape); }, body.shape)})) {
  const Eigen::Affine3d axes_from_tip = axesFromBed(machine);
  origin_from_tip_.linear() = body.motion * axes_from_tip.linear();
  origin_from_tip_.translation() =
      body.motion * axes_from_tip.translation() + body.bed_from_body_at_zero.translation();
  const auto reach = [&](const Point3& direction) {
    return extent(body.shape, rotation_.transpose() * direction);
  };
  for (int i = 0; i < 3; ++i) {
    around_origin_.box.low[i] = -reach(-Point3::Unit(i));
    around_origin_.box.high[i] = reach(Point3::Unit(i));
  }
  around_origin_.low_normal = -reach(-normal);
  around_origin_.high_normal = reach(normal);
}

Extents HeadBody::extentsAt(const Point3& origin) const {
  Extents extents = around_origin_;
  extents.box.low += origin;
  extents.box.high += origin;
  const double along = normal_.dot(origin);
  extents.low_normal += along;
  extents.high_normal += along;
  return extents;
}

bool HeadBody::meets(const DepositedBox& box, const Point3& origin) const {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotation_;
  pose.translation() = origin;
  const fcl::Boxd material(box.size.cast<double>());
  fcl::CollisionResultd result;
  return fcl::collide(solid_->geometry.get(), pose, &material, box.pose(), fcl::CollisionRequestd(), result) >
         0;
}

}  // namespace lamina
