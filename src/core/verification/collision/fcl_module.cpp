// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/collision/fcl_module.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <variant>
#include <vector>

#include "verification/collision/mesh_cells.hpp"

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

Owned triangleTree(const Mesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& corners : mesh.triangles) triangles.emplace_back(corners[0], corners[1], corners[2]);
  auto tree = std::make_unique<fcl::BVHModel<fcl::OBBRSSd>>();
  tree->beginModel();
  tree->addSubModel(mesh.vertices, triangles);
  tree->endModel();
  tree->computeLocalAABB();
  return tree;
}

/// FCL takes corners alone: faces would only lead it from corner to corner, of which there are few.
Owned geometryOf(const MeshShape& shape) {
  if (!shape.is_hull) return triangleTree(*shape.mesh);
  return std::make_unique<fcl::Convexd>(shape.hull, 0, std::make_shared<const std::vector<int>>());
}

struct FclShape final : CollisionShape {
  Owned geometry;
  double margin = 0.0;               ///< by which the geometry is larger [mm]
  std::shared_ptr<const Mesh> mesh;  ///< whose surface alone the geometry is; none of solids
  Point3 on_it = Point3::Zero();     ///< a point of the solid

  /// Of the mesh; made when first asked for, since much that is checked never comes near.
  const MeshCells& cells() const {
    std::call_once(is_divided_, [this] { cells_ = std::make_unique<const MeshCells>(*mesh); });
    return *cells_;
  }

 private:
  mutable std::once_flag is_divided_;
  mutable std::unique_ptr<const MeshCells> cells_;
};

/// Whether a solid of triangles swallows another whose surface it does not meet.
bool swallows(const FclShape& shape, const Eigen::Isometry3d& pose, const Point3& point) {
  if (!shape.mesh) return false;
  const Point3 seen = pose.inverse() * point;
  return shape.geometry->aabb_local.contain(seen) && shape.cells().isWithin(seen);
}

bool surfacesMeet(const FclShape& a, const Eigen::Isometry3d& pose_a, const FclShape& b,
                  const Eigen::Isometry3d& pose_b) {
  if (a.margin + b.margin > 0.0) {
    fcl::DistanceResultd result;
    return fcl::distance(a.geometry.get(), pose_a, b.geometry.get(), pose_b, fcl::DistanceRequestd(),
                         result) <= a.margin + b.margin;
  }
  fcl::CollisionResultd result;
  return fcl::collide(a.geometry.get(), pose_a, b.geometry.get(), pose_b, fcl::CollisionRequestd(), result) >
         0;
}

bool collide(const FclShape& a, const Eigen::Isometry3d& pose_a, const FclShape& b,
             const Eigen::Isometry3d& pose_b) {
  return surfacesMeet(a, pose_a, b, pose_b) || swallows(a, pose_a, pose_b * b.on_it) ||
         swallows(b, pose_b, pose_a * a.on_it);
}

const FclShape& fclShape(const CollisionShape& shape) { return static_cast<const FclShape&>(shape); }

std::shared_ptr<const CollisionShape> shapeOf(const BodyShape& shape) {
  auto made = std::make_shared<FclShape>();
  made->geometry = std::visit([](const auto& solid) { return geometryOf(solid); }, shape);
  const auto* mesh = std::get_if<MeshShape>(&shape);
  if (mesh == nullptr) return made;
  made->on_it = mesh->hull->front();
  if (mesh->is_hull)
    made->margin = mesh->margin_mm;
  else
    made->mesh = mesh->mesh;
  return made;
}

bool meet(const CollisionShape& a, const Eigen::Isometry3d& pose_a, const CollisionShape& b,
          const Eigen::Isometry3d& pose_b) {
  return collide(fclShape(a), pose_a, fclShape(b), pose_b);
}

double apart(const CollisionShape& a, const Eigen::Isometry3d& pose_a, const CollisionShape& b,
             const Eigen::Isometry3d& pose_b) {
  if (collide(fclShape(a), pose_a, fclShape(b), pose_b)) return 0.0;
  fcl::DistanceResultd result;
  const double between = fcl::distance(fclShape(a).geometry.get(), pose_a, fclShape(b).geometry.get(), pose_b,
                                       fcl::DistanceRequestd(), result);
  return std::max(0.0, between - fclShape(a).margin - fclShape(b).margin);
}

/// Whether a box is so far from all triangles of a mesh that it meets none.
bool isClearOf(const FclShape& shape, const Eigen::Isometry3d& pose, const Point3& size,
               const Eigen::Isometry3d& box_pose) {
  if (!shape.mesh) return false;
  const Eigen::Isometry3d seen = pose.inverse() * box_pose;
  const Point3 reach = seen.linear().cwiseAbs() * (0.5 * size);
  return shape.cells().isFarFrom({seen.translation() - reach, seen.translation() + reach});
}

bool meetsBox(const CollisionShape& shape, const Eigen::Isometry3d& pose, const Point3& size,
              const Eigen::Isometry3d& box_pose) {
  if (isClearOf(fclShape(shape), pose, size, box_pose))
    return swallows(fclShape(shape), pose, box_pose.translation());
  FclShape box;
  box.geometry = std::make_unique<fcl::Boxd>(size);
  return collide(fclShape(shape), pose, box, box_pose);
}

}  // namespace
}  // namespace lamina

// A name of C.
extern "C" const void* lamina_module();   // NOLINT(readability-identifier-naming)
extern "C" const void* lamina_module() {  // NOLINT(readability-identifier-naming)
  static constexpr lamina::FclModule kTable{&lamina::shapeOf, &lamina::meet, &lamina::apart,
                                            &lamina::meetsBox};
  return &kTable;
}
