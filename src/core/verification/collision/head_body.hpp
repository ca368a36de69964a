// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "lamina/kinematics/cartesian/machine_bodies.hpp"
#include "verification/collision/deposited_boxes.hpp"
#include "verification/collision/extents.hpp"
#include "verification/collision/solid.hpp"

namespace lamina {

/// A body of the machine over the bed, by where the nozzle tip is. It never turns.
class HeadBody {
 public:
  /// @param normal  of the layers [bed frame]
  HeadBody(const MachineBody& body, const CartesianMachine& machine, const Point3& normal);

  const std::string& link() const { return link_; }
  /// Origin of the body's frame [mm, bed frame].
  Point3 originFor(const Point3& tip) const { return origin_from_tip_ * tip; }
  Extents extentsAt(const Point3& origin) const;
  /// Whether it is in the box, by FCL.
  bool meets(const DepositedBox& box, const Point3& origin) const;

 private:
  std::string link_;
  Eigen::Affine3d origin_from_tip_;
  Eigen::Matrix3d rotation_;
  Point3 normal_;
  Solid solid_;
  Extents around_origin_;
};

}  // namespace lamina
