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

// Shapes of a machine's bodies, centred on the origin of their frame but for meshes.
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
/// Triangles that bound a solid, and points whose convex hull holds all of it but for a margin.
struct MeshShape {
  std::shared_ptr<const Mesh> mesh;                 ///< [mm, frame of the body]
  std::shared_ptr<const std::vector<Point3>> hull;  ///< some of its vertices, at most 256
  double margin_mm = 0.0;  ///< how far triangles, or what stands for them, reach beyond the hull at most
  bool is_hull = false;    ///< the hull, larger by the margin, stands for the triangles
};
using BodyShape = std::variant<BoxShape, CylinderShape, ConeShape, SphereShape, MeshShape>;

/// A mesh with the hull that stands for it where an estimate on the safe side is enough. The margin is an
/// upper bound: by how much the vertex that is left out furthest stands beyond the hull.
MeshShape meshShape(Mesh mesh);

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
/// @throws InvalidConfig if one has a size that is not positive, or is a mesh that is not named by file,
/// empty
///   or of more than two million triangles, naming the link; FileError, InvalidMesh as `readMesh`
std::vector<MachineBody> movingBodies(const CartesianMachine& machine);

/// How far the body reaches along a direction from the origin of its frame.
/// @param direction  of unit length [frame of the body]
/// @return [mm]
double extent(const BodyShape& shape, const Point3& direction);

}  // namespace lamina
