// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>
#include <vector>

#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

namespace lamina {

// Shapes of a machine's bodies, centred on the origin of their frame.
struct BoxShape {
  Point3 size_mm = Point3::Zero();
};
struct CylinderShape {  ///< along z
  double radius_mm = 0.0;
  double length_mm = 0.0;
};
struct ConeShape {  ///< along z, its apex at + length / 2
  double radius_mm = 0.0;
  double length_mm = 0.0;
};
struct SphereShape {
  double radius_mm = 0.0;
};
using BodyShape = std::variant<BoxShape, CylinderShape, ConeShape, SphereShape>;

/// A solid piece of a link that moves against the bed.
struct MachineBody {
  std::string link;
  BodyShape shape;
  Eigen::Isometry3d bed_from_body_at_zero = Eigen::Isometry3d::Identity();  ///< all axes at 0 [mm]
  Eigen::Matrix3d motion = Eigen::Matrix3d::Zero();  ///< columns: bed frame, per mm of x, y, z
};

/// The `<collision>` elements of all links that the linear axes move against the bed, rotary joints at zero,
/// in alphabetical order of the links. A cylinder whose collision is named `cone` is the cone in it with its
/// apex at + z: what reads no names sees a body that is larger.
/// @throws InvalidConfig if one is a mesh or has a size that is not positive, naming the link
std::vector<MachineBody> movingBodies(const CartesianMachine& machine);

/// How far the body reaches along a direction from the origin of its frame.
/// @param direction  of unit length [frame of the body]
/// @return [mm]
double extent(const BodyShape& shape, const Point3& direction);

}  // namespace lamina
