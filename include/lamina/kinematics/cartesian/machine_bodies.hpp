// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"

namespace lamina {

// Shapes of a machine's bodies. All but meshes are centred on the origin of their frame.
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
/// A solid bounded by triangles, and points whose convex hull, grown by a margin, contains the solid.
struct MeshShape {
  std::shared_ptr<const Mesh> mesh;                 ///< [mm, frame of the body]
  std::shared_ptr<const std::vector<Point3>> hull;  ///< some of its vertices, at most 256
  double margin_mm = 0.0;  ///< greatest distance by which the solid reaches beyond the hull
  bool is_hull = false;    ///< whether the hull, grown by the margin, replaces the triangles as the shape
};
using BodyShape = std::variant<BoxShape, CylinderShape, ConeShape, SphereShape, MeshShape>;

/// A mesh, and the hull that replaces it where a conservative estimate is enough. The margin is an upper
/// bound: the distance from the hull to the farthest vertex that it leaves out.
MeshShape meshShape(Mesh mesh);

/// A solid piece of a link that moves relative to the bed.
struct MachineBody {
  std::string link;
  BodyShape shape;
  Eigen::Isometry3d bed_from_body_at_zero = Eigen::Isometry3d::Identity();  ///< with all axes at 0 [mm]
  /// Displacement per mm of x, y and z, a column each [bed frame].
  Eigen::Matrix3d motion = Eigen::Matrix3d::Zero();
};

/// The `<collision>` elements of all links that the linear axes move relative to the bed, with rotary joints
/// at zero, in alphabetical order of the links. A cylinder whose collision is named `cone` is read as the
/// inscribed cone with its apex at + z; readers that ignore names see the larger cylinder.
/// @throws InvalidConfig naming the link, if a size is not positive, or a mesh is not given by file, is empty
///   or has more than two million triangles
/// @throws FileError, InvalidMesh as `readMesh`
std::vector<MachineBody> movingBodies(const CartesianMachine& machine);

/// Support function of a shape: its greatest extent along a direction, from the origin of its frame.
/// @param direction  of unit length [frame of the body]
/// @return [mm]
double extent(const BodyShape& shape, const Point3& direction);

/// Radius of a sphere about the origin of a shape's frame that contains the shape [mm].
double boundingRadius(const BodyShape& shape);

}  // namespace lamina
