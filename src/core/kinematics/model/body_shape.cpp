// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/body_shape.hpp"

#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"

namespace lamina {
namespace {

constexpr double kBodyMillimetres = 1e3;  // in the metre of URDF
constexpr const char* kCone = "cone";
constexpr std::size_t kMostTriangles = 2000000;

[[noreturn]] void refuse(const std::string& link, const std::string& what) {
  throw InvalidConfig("collision of link '" + link + "' " + what);
}

double positive(double metres, const std::string& link) {
  if (!(metres > 0.0)) refuse(link, "has a size of " + numberText(metres) + " m; expected a positive one");
  return kBodyMillimetres * metres;
}

BodyShape meshOf(const urdf::Mesh& source, const std::string& link) {
  const std::string scheme = "file://";
  if (source.filename.rfind(scheme, 0) != 0)
    refuse(link, "is the mesh '" + source.filename + "'; expected file:// and an absolute path");
  Mesh mesh = readMesh(source.filename.substr(scheme.size()), {LengthUnit::Metre, 1.0});
  if (mesh.triangles.size() > kMostTriangles)
    refuse(link, "has " + std::to_string(mesh.triangles.size()) + " triangles; expected " +
                     std::to_string(kMostTriangles) + " at most");
  const Point3 scale(source.scale.x, source.scale.y, source.scale.z);
  if (!((scale.array().abs() > 0.0).all() && scale.allFinite()))
    refuse(link, "has a mesh with a scale of 0; expected another");
  for (Point3& vertex : mesh.vertices) vertex = vertex.cwiseProduct(scale);
  return meshShape(std::move(mesh));
}

}  // namespace

BodyShape shapeOf(const urdf::Collision& collision, const std::string& link) {
  const urdf::Geometry* geometry = collision.geometry.get();
  if (const auto* box = dynamic_cast<const urdf::Box*>(geometry))
    return BoxShape{{positive(box->dim.x, link), positive(box->dim.y, link), positive(box->dim.z, link)}};
  if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(geometry))
    return SphereShape{positive(sphere->radius, link)};
  if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(geometry)) return meshOf(*mesh, link);
  const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(geometry);
  if (cylinder == nullptr) refuse(link, "has no geometry; expected a box, cylinder, sphere or mesh");
  const double radius = positive(cylinder->radius, link);
  const double length = positive(cylinder->length, link);
  if (collision.name == kCone) return ConeShape{radius, length};
  return CylinderShape{radius, length};
}

}  // namespace lamina
