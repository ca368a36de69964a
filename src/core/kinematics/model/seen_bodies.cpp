// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/seen_bodies.hpp"

#include <utility>
#include <variant>

#include "geometry/parts/shapes.hpp"
#include "kinematics/model/body_shape.hpp"
#include "kinematics/model/link_motion.hpp"

namespace lamina {
namespace {

constexpr int kSeenSegments = 32;  // around what is round

Mesh shifted(Mesh mesh, const Point3& by) {
  for (Point3& vertex : mesh.vertices) vertex += by;
  return mesh;
}

/// Parts stand on z = 0, shapes are centred.
struct SeenShape {
  Mesh operator()(const BoxShape& box) const {
    const Point3& size = box.size_mm;
    Mesh mesh = build(CuboidShape{size.x(), size.y(), size.z()});
    const Box3 around = boundingBox(mesh);
    return shifted(std::move(mesh), -0.5 * (around.low + around.high));
  }
  Mesh operator()(const CylinderShape& cylinder) const {
    return shifted(build(Cylinder{cylinder.radius_mm, cylinder.length_mm, kSeenSegments}),
                   {0.0, 0.0, -0.5 * cylinder.length_mm});
  }
  Mesh operator()(const ConeShape& cone) const {
    return shifted(build(Cone{cone.radius_mm, 0.0, cone.length_mm, kSeenSegments}),
                   {0.0, 0.0, -0.5 * cone.length_mm});
  }
  Mesh operator()(const SphereShape& sphere) const {
    return shifted(build(Sphere{sphere.radius_mm, kSeenSegments}), {0.0, 0.0, -sphere.radius_mm});
  }
  Mesh operator()(const MeshShape& shape) const { return *shape.mesh; }
};

DisplayBody seenBody(const urdf::Collision& element, const std::string& link) {
  DisplayBody body;
  body.link = link;
  body.mesh = std::visit(SeenShape(), shapeOf(element, link));
  const Eigen::Isometry3d link_from_body = poseOf(element.origin);
  for (Point3& vertex : body.mesh.vertices) vertex = link_from_body * vertex;
  return body;
}

}  // namespace

std::vector<DisplayBody> displayBodies(const std::string& urdf) {
  const auto model = parseMachine(urdf);
  std::vector<DisplayBody> bodies;
  for (const auto& [name, link] : model->links_) {
    for (const auto& visual : link->visual_array) {
      urdf::Collision element;
      element.origin = visual->origin;
      element.geometry = visual->geometry;
      bodies.push_back(seenBody(element, name));
      if (visual->material)
        bodies.back().colour = {visual->material->color.r, visual->material->color.g,
                                visual->material->color.b};
    }
    if (!link->visual_array.empty()) continue;
    for (const auto& collision : link->collision_array) bodies.push_back(seenBody(*collision, name));
  }
  return bodies;
}

}  // namespace lamina
