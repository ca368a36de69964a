// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/body_shape.hpp"

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kBodyMillimetres = 1e3;  // in the metre of URDF
constexpr const char* kCone = "cone";

[[noreturn]] void refuse(const std::string& link, const std::string& what) {
  throw InvalidConfig("collision of link '" + link + "' " + what);
}

double positive(double metres, const std::string& link) {
  if (!(metres > 0.0))
    refuse(link, "has a size of " + std::to_string(metres) + " m; expected a positive one");
  return kBodyMillimetres * metres;
}

}  // namespace

BodyShape shapeOf(const urdf::Collision& collision, const std::string& link) {
  const urdf::Geometry* geometry = collision.geometry.get();
  if (const auto* box = dynamic_cast<const urdf::Box*>(geometry))
    return BoxShape{{positive(box->dim.x, link), positive(box->dim.y, link), positive(box->dim.z, link)}};
  if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(geometry))
    return SphereShape{positive(sphere->radius, link)};
  const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(geometry);
  if (cylinder == nullptr) refuse(link, "is a mesh; expected a box, cylinder or sphere");
  const double radius = positive(cylinder->radius, link);
  const double length = positive(cylinder->length, link);
  if (collision.name == kCone) return ConeShape{radius, length};
  return CylinderShape{radius, length};
}

}  // namespace lamina
