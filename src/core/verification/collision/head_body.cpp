// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/head_body.hpp"

namespace lamina {

HeadBody::HeadBody(const MachineBody& body, const CartesianMachine& machine, const Point3& normal)
    : link_(body.link),
      rotation_(body.bed_from_body_at_zero.linear()),
      normal_(normal),
      solid_(body.shape),
      around_origin_(solid_.extentsAt(Eigen::Isometry3d(rotation_), normal)) {
  const Eigen::Affine3d axes_from_tip = axesFromBed(machine);
  origin_from_tip_.linear() = body.motion * axes_from_tip.linear();
  origin_from_tip_.translation() =
      body.motion * axes_from_tip.translation() + body.bed_from_body_at_zero.translation();
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
  return solid_.meets(box, pose);
}

}  // namespace lamina
